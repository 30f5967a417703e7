// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/interior_edges.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/gradient_orientation.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kRim = 4;          // [px] beside the outline, where edges are its own
constexpr int kSlack = 2;        // [px] between the two places of an edge
constexpr float kStrong = 0.5F;  // length of an edge vector
constexpr float kFaint = 0.2F;   // length of the other's vector along the edge, at least
constexpr int kEnough = 60;      // pixels of strong edges that tell

using Vector = cv::Vec<schar, 2>;

float dot(const Vector& a, const cv::Vec2f& b) {
  return a[0] * b[0] + a[1] * b[1];
}

bool is_strong(const Vector& edge) {
  constexpr float kLength = kStrong * imaging::kEdgeScale;
  return dot(edge, edge) > kLength * kLength;
}

/// Of length 1, turned by the rotation of which `turn` is the double: angles of edges are doubled.
cv::Vec2f direction_of(const Vector& edge, const cv::Vec2f& turn) {
  const cv::Vec2f turned(dot(edge, {turn[0], -turn[1]}), dot(edge, {turn[1], turn[0]}));
  return turned / std::sqrt(dot(edge, edge));
}

/// Places around a pixel, the nearest first.
std::vector<cv::Point> places_around() {
  std::vector<cv::Point> places;
  for (int y = -kSlack; y <= kSlack; ++y)
    for (int x = -kSlack; x <= kSlack; ++x) places.emplace_back(x, y);
  std::stable_sort(places.begin(), places.end(),
                   [](const cv::Point& a, const cv::Point& b) { return a.dot(a) < b.dot(b); });
  return places;
}

/// Whether `edges` have one of this direction near `at`.
bool has_along(const cv::Mat& edges, const cv::Point& at, const cv::Vec2f& direction) {
  static const std::vector<cv::Point> places = places_around();
  const cv::Rect image({0, 0}, edges.size());
  return std::any_of(places.begin(), places.end(), [&](const cv::Point& by) {
    const cv::Point place = at + by;
    return place.inside(image) &&
           dot(edges.at<Vector>(place), direction) > kFaint * imaging::kEdgeScale;
  });
}

}  // namespace

InteriorEdges::InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map,
                             cv::Point2d anchor)
    : edges_(lesson.whole().edges.clone()), anchor_(anchor) {
  cv::erode(map, inside_, cv::Mat::ones(2 * kRim + 1, 2 * kRim + 1, CV_8U), {-1, -1}, 1,
            cv::BORDER_CONSTANT, cv::Scalar(0));
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x) {
      if (!inside_.at<uchar>(y, x)) continue;
      reach_ = std::max(reach_, std::hypot(x - anchor.x, y - anchor.y));
      if (is_strong(edges_.at<Vector>(y, x))) strong_.emplace_back(x, y);
    }
}

double InteriorEdges::shared(const scene::SceneLevel& scene, const Pose2D& pose,
                             double scale) const {
  const cv::Mat& edges = scene.around(pose, scale * reach_ + kSlack).edges;
  const cv::Rect image({0, 0}, edges.size());
  const cv::Vec2f turn(static_cast<float>(std::cos(2 * pose.theta)),
                       static_cast<float>(std::sin(2 * pose.theta)));
  const cv::Vec2f back(turn[0], -turn[1]);
  int all = 0, both = 0;
  for (const cv::Point& pixel : strong_) {
    const cv::Point2d seen = transform(pose, scale * (cv::Point2d(pixel) - anchor_));
    const cv::Point at(cvRound(seen.x), cvRound(seen.y));
    if (!at.inside(image)) continue;
    ++all;
    both += has_along(edges, at, direction_of(edges_.at<Vector>(pixel), turn));
  }
  const Pose2D inverted = inverse(pose);
  const int reach = static_cast<int>(std::ceil(scale * reach_));
  const cv::Rect box =
      cv::Rect(cvRound(pose.x) - reach, cvRound(pose.y) - reach, 2 * reach + 1, 2 * reach + 1) &
      image;
  for (int y = box.y; y < box.br().y; ++y)
    for (int x = box.x; x < box.br().x; ++x) {
      const Vector& edge = edges.at<Vector>(y, x);
      if (!is_strong(edge)) continue;
      const cv::Point2d learned = transform(inverted, cv::Point2d(x, y)) / scale + anchor_;
      const cv::Point at(cvRound(learned.x), cvRound(learned.y));
      if (!at.inside(cv::Rect({0, 0}, inside_.size())) || !inside_.at<uchar>(at)) continue;
      ++all;
      both += has_along(edges_, at, direction_of(edge, back));
    }
  return all < kEnough ? 1 : both / static_cast<double>(all);
}

}  // namespace mbncc::evidence
