// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/interior_edges.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/gradient_orientation.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kRim = 4;         // [px] beside the outline, where edges are its own
constexpr int kSlack = 2;       // [px] between the two places of an edge
constexpr float kClear = 0.5F;  // length of an edge vector
constexpr float kFaint = 0.2F;  // length of the other's vector along the edge, at least

constexpr int kBeside = 7;  // [px] square about a pixel of a highlight: its edge

using Vector = cv::Vec<schar, 2>;

/// Sum of the channels.
int brightness(const cv::Vec3b& colour) {
  return colour[0] + colour[1] + colour[2];
}

float dot(const Vector& a, const cv::Vec2f& b) {
  return a[0] * b[0] + a[1] * b[1];
}

bool is_clear(const Vector& edge) {
  constexpr float kLength = kClear * imaging::kEdgeScale;
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

/// Pixels of the largest connected group.
int largest_group(const cv::Mat& pixels) {
  cv::Mat labels, stats, centres;
  const int groups = cv::connectedComponentsWithStats(pixels, labels, stats, centres);
  int largest = 0;
  for (int i = 1; i < groups; ++i) largest = std::max(largest, stats.at<int>(i, cv::CC_STAT_AREA));
  return largest;
}

}  // namespace

InteriorEdges::InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map,
                             cv::Point2d anchor)
    : colour_(lesson.whole().colour.clone()),
      edges_(lesson.whole().edges.clone()),
      anchor_(anchor) {
  cv::erode(map, inside_, cv::Mat::ones(2 * kRim + 1, 2 * kRim + 1, CV_8U), {-1, -1}, 1,
            cv::BORDER_CONSTANT, cv::Scalar(0));
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x) {
      if (!inside_.at<uchar>(y, x)) continue;
      reach_ = std::max(reach_, std::hypot(x - anchor.x, y - anchor.y));
      if (is_clear(edges_.at<Vector>(y, x))) clear_.emplace_back(x, y);
    }
}

double InteriorEdges::difference(const scene::SceneLevel& scene, const Pose2D& pose,
                                 double scale) const {
  const int area = cv::countNonZero(inside_);
  if (area == 0) return 0;
  const scene::PreparedPixels pixels = scene.around(pose, scale * reach_ + kSlack);
  const cv::Mat where = compared(pixels.colour, pose, scale);
  const int largest = std::max(largest_group(missing(pixels.edges, where, pose, scale)),
                               largest_group(added(pixels.edges, where, pose, scale)));
  return largest / std::sqrt(area);
}

/// CV_8UC1 in the lesson: 255 inside the outline, away from what saturates in the image though it
/// would not in the image's light.
cv::Mat InteriorEdges::compared(const cv::Mat& colour, const Pose2D& pose, double scale) const {
  const cv::Rect image({0, 0}, colour.size());
  cv::Mat saturated = cv::Mat::zeros(inside_.size(), CV_8UC1);
  double learned = 0, seen = 0;
  int open = 0;
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x) {
      if (!inside_.at<uchar>(y, x)) continue;
      const cv::Point2d place = transform(pose, scale * (cv::Point2d(x, y) - anchor_));
      const cv::Point at(cvRound(place.x), cvRound(place.y));
      if (!at.inside(image)) continue;
      const auto& pixel = colour.at<cv::Vec3b>(at);
      if (std::min({pixel[0], pixel[1], pixel[2]}) >= templates::kSaturated) {
        saturated.at<uchar>(y, x) = 255;
        continue;
      }
      ++open;
      learned += brightness(colour_.at<cv::Vec3b>(y, x));
      seen += brightness(pixel);
    }
  const int all = cv::countNonZero(saturated);
  if (all == 0 || open <= all) return inside_;
  const double gain = seen / std::max(1.0, learned);
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x)
      if (gain * brightness(colour_.at<cv::Vec3b>(y, x)) >= templates::kMaySaturate)
        saturated.at<uchar>(y, x) = 0;
  cv::dilate(saturated, saturated, cv::Mat::ones(kBeside, kBeside, CV_8U));
  return inside_ & ~saturated;
}

/// CV_8UC1 in the lesson: 255 where its clear edges are not in the image's `edges`.
cv::Mat InteriorEdges::missing(const cv::Mat& edges, const cv::Mat& where, const Pose2D& pose,
                               double scale) const {
  const cv::Rect image({0, 0}, edges.size());
  const cv::Vec2f turn(static_cast<float>(std::cos(2 * pose.theta)),
                       static_cast<float>(std::sin(2 * pose.theta)));
  cv::Mat pixels = cv::Mat::zeros(inside_.size(), CV_8UC1);
  for (const cv::Point& pixel : clear_) {
    if (!where.at<uchar>(pixel)) continue;
    const cv::Point2d seen = transform(pose, scale * (cv::Point2d(pixel) - anchor_));
    const cv::Point at(cvRound(seen.x), cvRound(seen.y));
    if (at.inside(image) && !has_along(edges, at, direction_of(edges_.at<Vector>(pixel), turn)))
      pixels.at<uchar>(pixel) = 255;
  }
  return pixels;
}

/// CV_8UC1 about the pose in the image: 255 where its clear edges are not in the lesson.
cv::Mat InteriorEdges::added(const cv::Mat& edges, const cv::Mat& where, const Pose2D& pose,
                             double scale) const {
  const cv::Rect lesson({0, 0}, inside_.size());
  const cv::Vec2f turn(static_cast<float>(std::cos(2 * pose.theta)),
                       static_cast<float>(-std::sin(2 * pose.theta)));
  const Pose2D into_lesson = inverse(pose);
  const int reach = static_cast<int>(std::ceil(scale * reach_));
  const cv::Rect box =
      cv::Rect(cvRound(pose.x) - reach, cvRound(pose.y) - reach, 2 * reach + 1, 2 * reach + 1) &
      cv::Rect({0, 0}, edges.size());
  cv::Mat pixels = cv::Mat::zeros(box.size(), CV_8UC1);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      const Vector& edge = edges.at<Vector>(box.y + y, box.x + x);
      if (!is_clear(edge)) continue;
      const cv::Point2d learned =
          transform(into_lesson, cv::Point2d(box.x + x, box.y + y)) / scale + anchor_;
      const cv::Point at(cvRound(learned.x), cvRound(learned.y));
      if (at.inside(lesson) && where.at<uchar>(at) &&
          !has_along(edges_, at, direction_of(edge, turn)))
        pixels.at<uchar>(y, x) = 255;
    }
  return pixels;
}

}  // namespace mbncc::evidence
