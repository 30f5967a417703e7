// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/similarity.hpp"

#include <algorithm>
#include <cmath>

#include "imaging/pyramid.hpp"
#include "imaging/sampling.hpp"
#include "matching/template/map_level.hpp"

namespace mbncc {
namespace {

/// Sums over the visible pairs of template and image values.
struct Moments {
  double count = 0, t = 0, s = 0, tt = 0, ss = 0, ts = 0;

  void add(double template_value, double image_value) {
    count += 1;
    t += template_value;
    s += image_value;
    tt += template_value * template_value;
    ss += image_value * image_value;
    ts += template_value * image_value;
  }

  double correlation(double noise_variance) const {
    const double covariance = ts / count - t / count * (s / count);
    const double variance_t = std::max(0.0, tt / count - t / count * (t / count));
    const double variance_s = std::max(0.0, ss / count - s / count * (s / count));
    const double square = (variance_t + noise_variance) * (variance_s + noise_variance);
    return square > 0 ? covariance / std::sqrt(square) : 0;
  }
};

}  // namespace

MaskedTemplate masked_template(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor,
                               int level) {
  constexpr float kInside = 0.5f;
  const templates::MapLevel at_level = templates::map_level(grey, map, level);
  const cv::Point2d origin = imaging::to_level(anchor, level);
  MaskedTemplate points;
  for (int y = 0; y < at_level.values.rows; ++y) {
    for (int x = 0; x < at_level.values.cols; ++x) {
      if (at_level.coverage.at<float>(y, x) < kInside) continue;
      points.x.push_back(static_cast<float>(x - origin.x));
      points.y.push_back(static_cast<float>(y - origin.y));
      points.values.push_back(at_level.values.at<float>(y, x));
    }
  }
  return points;
}

Similarity similarity(const MaskedTemplate& points, const cv::Mat& grey, const Pose2D& pose,
                      double noise_variance) {
  const imaging::GreySampler image(grey);
  const float c = static_cast<float>(std::cos(pose.theta));
  const float s = static_cast<float>(std::sin(pose.theta));
  const float x0 = static_cast<float>(pose.x), y0 = static_cast<float>(pose.y);
  Moments moments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = c * points.x[i] - s * points.y[i] + x0;
    const float y = s * points.x[i] + c * points.y[i] + y0;
    if (image.contains(x, y)) moments.add(points.values[i], image(x, y));
  }
  Similarity result;
  if (points.size() == 0) return result;
  result.visible = moments.count / static_cast<double>(points.size());
  if (result.visible >= 0.25) result.value = moments.correlation(noise_variance);
  return result;
}

}  // namespace mbncc
