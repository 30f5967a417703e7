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

/// Of length 1, turned by `angle` [rad]: angles of edges are doubled.
cv::Vec2f direction_of(const Vector& edge, double angle) {
  const auto c = static_cast<float>(std::cos(2 * angle)),
             s = static_cast<float>(std::sin(2 * angle));
  return cv::Vec2f(dot(edge, {c, -s}), dot(edge, {s, c})) / std::sqrt(dot(edge, edge));
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

/// CV_8UC1: 255 within `where` where `edges`, turned by `angle` [rad], are clear and not in
/// `others`.
cv::Mat only_in(const cv::Mat& edges, double angle, const cv::Mat& others, const cv::Mat& where) {
  cv::Mat pixels = cv::Mat::zeros(edges.size(), CV_8UC1);
  for (int y = 0; y < edges.rows; ++y)
    for (int x = 0; x < edges.cols; ++x) {
      const Vector& edge = edges.at<Vector>(y, x);
      if (where.at<uchar>(y, x) && is_clear(edge) &&
          !has_along(others, {x, y}, direction_of(edge, angle)))
        pixels.at<uchar>(y, x) = 255;
    }
  return pixels;
}

/// Whether most of the contour is found beside `at` [px about the anchor].
bool outline_is_found_beside(const cv::Point2d& at, const templates::ContourTemplate& contour,
                             const templates::ContourSample& sample) {
  float seen = 0, found = 0;
  for (const int k : templates::points_beside(contour, at)) {
    seen += sample.seen[k];
    if (templates::is_clear(sample.response[k])) found += sample.seen[k];
  }
  return found > seen / 2;
}

struct Group {
  int size = 0;          ///< [px]
  bool reaches = false;  ///< the border of where edges are compared
  cv::Point2d centre;
};

/// Connected groups of `pixels`, which lie within `where`.
std::vector<Group> groups_of(const cv::Mat& pixels, const cv::Mat& where) {
  cv::Mat labels, stats, centres, rim;
  std::vector<Group> groups(cv::connectedComponentsWithStats(pixels, labels, stats, centres));
  for (std::size_t i = 1; i < groups.size(); ++i) {
    const int row = static_cast<int>(i);
    groups[i].size = stats.at<int>(row, cv::CC_STAT_AREA);
    groups[i].centre = {centres.at<double>(row, 0), centres.at<double>(row, 1)};
  }
  cv::dilate(~where, rim, cv::Mat::ones(2 * kSlack + 1, 2 * kSlack + 1, CV_8U));
  for (int y = 0; y < rim.rows; ++y)
    for (int x = 0; x < rim.cols; ++x)
      if (rim.at<uchar>(y, x)) groups[labels.at<int>(y, x)].reaches = true;
  return groups;
}

}  // namespace

InteriorEdges::InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map,
                             cv::Point2d anchor) {
  const cv::Rect box = cv::boundingRect(map);
  colour_ = lesson.whole().colour(box).clone();
  edges_ = lesson.whole().edges(box).clone();
  anchor_ = anchor - cv::Point2d(box.tl());
  cv::erode(map(box).clone(), inside_, cv::Mat::ones(2 * kRim + 1, 2 * kRim + 1, CV_8U), {-1, -1},
            1, cv::BORDER_CONSTANT, cv::Scalar(0));
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x)
      if (inside_.at<uchar>(y, x))
        reach_ = std::max(reach_, std::hypot(x - anchor_.x, y - anchor_.y));
}

InteriorDifference InteriorEdges::difference(const scene::SceneLevel& scene,
                                             const templates::ContourTemplate& contour,
                                             const Pose2D& pose, double scale) const {
  const int area = cv::countNonZero(inside_);
  if (area == 0) return {};
  const scene::PreparedPixels image =
      scene.around(pose, scale * std::max(reach_, contour.radius()) + kSlack);
  const Seen seen = at_pose(image, pose, scale);
  const cv::Mat where = without_highlights(seen) & seen.inside;
  const cv::Mat pixels = only_in(edges_, pose.theta, seen.edges, where) |
                         only_in(seen.edges, -pose.theta, edges_, where);
  int largest = 0, enclosed = 0;
  templates::ContourSample outline;
  for (const Group& group : groups_of(pixels, where)) {
    largest = std::max(largest, group.size);
    if (group.reaches || group.size <= enclosed) continue;
    if (outline.response.empty())
      templates::read_contour(contour, image.edges, pose, 1, outline, scale);
    if (outline_is_found_beside(group.centre - anchor_, contour, outline)) enclosed = group.size;
  }
  return {largest / std::sqrt(area), enclosed / std::sqrt(area)};
}

InteriorEdges::Seen InteriorEdges::at_pose(const scene::PreparedPixels& pixels, const Pose2D& pose,
                                           double scale) const {
  const int reach = static_cast<int>(std::ceil(scale * reach_)) + kSlack;
  const cv::Rect box =
      cv::Rect(cvRound(pose.x) - reach, cvRound(pose.y) - reach, 2 * reach + 1, 2 * reach + 1) &
      cv::Rect({0, 0}, pixels.size());
  if (box.empty())
    return {cv::Mat::zeros(inside_.size(), CV_8UC3), cv::Mat::zeros(inside_.size(), CV_8SC2),
            cv::Mat::zeros(inside_.size(), CV_8UC1)};
  const Pose2D turn{0, 0, pose.theta};
  const cv::Point2d x = transform(turn, {scale, 0}), y = transform(turn, {0, scale});
  const cv::Point2d corner =
      transform(pose, -scale * anchor_) - cv::Point2d(box.tl());  // the lesson's first pixel
  const cv::Matx23d into_box(x.x, y.x, corner.x, x.y, y.y, corner.y);
  const auto read = [&](const cv::Mat& image) {
    cv::Mat read;
    cv::warpAffine(image, read, into_box, inside_.size(), cv::INTER_NEAREST | cv::WARP_INVERSE_MAP);
    return read;
  };
  return {read(pixels.colour(box)), read(pixels.edges(box)),
          read(cv::Mat(box.size(), CV_8UC1, cv::Scalar(255)))};
}

/// CV_8UC1: 255 inside the outline, away from what saturates in the image though it would not in
/// the image's light.
cv::Mat InteriorEdges::without_highlights(const Seen& seen) const {
  cv::Mat saturated = cv::Mat::zeros(inside_.size(), CV_8UC1);
  double learned = 0, bright = 0;
  int open = 0;
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x) {
      if (!inside_.at<uchar>(y, x) || !seen.inside.at<uchar>(y, x)) continue;
      const auto& pixel = seen.colour.at<cv::Vec3b>(y, x);
      if (std::min({pixel[0], pixel[1], pixel[2]}) >= templates::kSaturated) {
        saturated.at<uchar>(y, x) = 255;
        continue;
      }
      ++open;
      learned += brightness(colour_.at<cv::Vec3b>(y, x));
      bright += brightness(pixel);
    }
  const int all = cv::countNonZero(saturated);
  if (all == 0 || open <= all) return inside_;
  const double gain = bright / std::max(1.0, learned);
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x)
      if (gain * brightness(colour_.at<cv::Vec3b>(y, x)) >= templates::kMaySaturate)
        saturated.at<uchar>(y, x) = 0;
  cv::dilate(saturated, saturated, cv::Mat::ones(kBeside, kBeside, CV_8U));
  return inside_ & ~saturated;
}

}  // namespace mbncc::evidence
