// SPDX-License-Identifier: BSD-3-Clause
#include "learning/quality/detached_part.hpp"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::quality {
namespace {

// Bounds of docs/decisions/0011-verdict.md.
constexpr double kSmall = 0.05;  // [map's area] least area of a part that is no slip
constexpr double kLarger = 1.1;  // growth of the excircle's radius by small parts

struct Parts {
  cv::Mat labels, measures, centroids;
  std::vector<bool> is_small;  // by label; 0 is the background
};

Parts parts_of(const cv::Mat& map) {
  Parts parts;
  const int count =
      cv::connectedComponentsWithStats(map, parts.labels, parts.measures, parts.centroids);
  const double small = kSmall * cv::countNonZero(map);
  parts.is_small.resize(static_cast<std::size_t>(count));
  for (int label = 1; label < count; ++label)
    parts.is_small[static_cast<std::size_t>(label)] =
        parts.measures.at<int>(label, cv::CC_STAT_AREA) < small;
  return parts;
}

cv::Mat without_small(const Parts& parts, const cv::Mat& map) {
  cv::Mat body = map.clone();
  for (int y = 0; y < body.rows; ++y)
    for (int x = 0; x < body.cols; ++x)
      if (parts.is_small[static_cast<std::size_t>(parts.labels.at<int>(y, x))])
        body.at<uchar>(y, x) = 0;
  return body;
}

}  // namespace

std::optional<DetachedPart> detached_part(const cv::Mat& map) {
  const Parts parts = parts_of(map);
  const cv::Mat body = without_small(parts, map);
  if (cv::countNonZero(body) == 0) return std::nullopt;
  const Circle circle = excircle(body);
  if (excircle(map).radius <= kLarger * circle.radius) return std::nullopt;
  DetachedPart farthest;
  double distance = 0;
  for (int label = 1; label < parts.measures.rows; ++label) {
    const cv::Point2d centre(parts.centroids.at<double>(label, 0),
                             parts.centroids.at<double>(label, 1));
    const double from_body = cv::norm(centre - circle.centre);
    if (!parts.is_small[static_cast<std::size_t>(label)] || from_body <= distance) continue;
    distance = from_body;
    farthest = {parts.measures.at<int>(label, cv::CC_STAT_AREA), cv::Point(centre)};
  }
  return farthest;
}

}  // namespace mbncc::quality
