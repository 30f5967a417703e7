// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/interior_edges.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/gradient_orientation.hpp"
#include "matching/evidence/lesson_pixels.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kRim = 4;         // [px] width of the rim whose edges belong to the outline
constexpr int kSlack = 2;       // [px] tolerated displacement of an edge
constexpr float kClear = 0.5F;  // least length of a clear edge vector
constexpr float kFaint = 0.2F;  // least component of its counterpart along it

constexpr int kBeside = 7;  // [px] side of the square around a highlight pixel with its edges

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

/// Rotation of edge vectors, whose angles are doubled.
struct Turn {
  explicit Turn(double angle)
      : c(static_cast<float>(std::cos(2 * angle))), s(static_cast<float>(std::sin(2 * angle))) {}

  /// Unit vector along the rotated edge.
  cv::Vec2f direction_of(const Vector& edge) const {
    return cv::Vec2f(dot(edge, {c, -s}), dot(edge, {s, c})) / std::sqrt(dot(edge, edge));
  }

  float c, s;
};

/// Edge image with a margin, in which edges near a pixel are looked up.
class EdgesAround {
 public:
  explicit EdgesAround(const cv::Mat& edges) {
    cv::copyMakeBorder(edges, edges_, kSlack, kSlack, kSlack, kSlack, cv::BORDER_CONSTANT);
  }

  /// Whether there is an edge of this direction near (x, y).
  bool has_along(int x, int y, const cv::Vec2f& direction) const {
    for (int row = y; row <= y + 2 * kSlack; ++row) {
      const auto* edge = edges_.ptr<Vector>(row) + x;
      for (int column = 0; column <= 2 * kSlack; ++column)
        if (dot(edge[column], direction) > kFaint * imaging::kEdgeScale) return true;
    }
    return false;
  }

 private:
  cv::Mat edges_;
};

/// CV_8UC1: 255 within `where` at each clear edge of `edges` that, rotated by `angle` [rad], has no
/// counterpart in `others`.
cv::Mat only_in(const cv::Mat& edges, double angle, const cv::Mat& others, const cv::Mat& where) {
  const EdgesAround around(others);
  const Turn turn(angle);
  cv::Mat pixels = cv::Mat::zeros(edges.size(), CV_8UC1);
  for (int y = 0; y < edges.rows; ++y) {
    const auto* edge = edges.ptr<Vector>(y);
    const uchar* compared = where.ptr(y);
    uchar* pixel = pixels.ptr(y);
    for (int x = 0; x < edges.cols; ++x)
      if (compared[x] && is_clear(edge[x]) && !around.has_along(x, y, turn.direction_of(edge[x])))
        pixel[x] = 255;
  }
  return pixels;
}

struct Group {
  int size = 0;          ///< [px]
  bool reaches = false;  ///< touches the border of the compared area
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

double InteriorEdges::difference(const scene::SceneLevel& scene,
                                 const templates::ContourTemplate& contour,
                                 const templates::ContourSample& outline, const Pose2D& pose,
                                 double scale) const {
  constexpr double kLeastFound = 0.5;  // least part of the outline found beside a group
  const int area = cv::countNonZero(inside_);
  if (area == 0) return 0;
  const scene::PreparedPixels image = scene.around(pose, scale * reach_ + 2 * kSlack);
  const LessonPixels pixels(inside_.size(), anchor_, image.size(), pose, scale);
  const Seen seen{pixels.read(image.colour, cv::INTER_NEAREST),
                  pixels.read(image.edges, cv::INTER_NEAREST), pixels.inside()};
  const cv::Mat where = without_highlights(seen) & seen.inside;
  const cv::Mat differing = only_in(edges_, pose.theta, seen.edges, where) |
                            only_in(seen.edges, -pose.theta, edges_, where);
  int largest = 0;
  for (const Group& group : groups_of(differing, where)) {
    if (group.reaches || group.size <= largest) continue;
    if (templates::contour_found_beside(contour, outline, group.centre - anchor_) > kLeastFound)
      largest = group.size;
  }
  return largest / std::sqrt(area);
}

/// CV_8UC1: 255 inside the outline, except near pixels that are saturated in the image although the
/// object would not saturate in this light.
cv::Mat InteriorEdges::without_highlights(const Seen& seen) const {
  const cv::Scalar least = cv::Scalar::all(templates::kSaturated), most = cv::Scalar::all(255);
  const cv::Mat shown = inside_ & seen.inside;
  cv::Mat saturated;
  cv::inRange(seen.colour, least, most, saturated);
  saturated &= shown;
  const int all = cv::countNonZero(saturated);
  const cv::Mat open = shown & ~saturated;
  const int shown_well = cv::countNonZero(open);
  if (all == 0 || shown_well <= all) return inside_;
  const auto sum = [&](const cv::Mat& colour) {
    const cv::Scalar mean = cv::mean(colour, open);
    return shown_well * (mean[0] + mean[1] + mean[2]);
  };
  const double gain = sum(seen.colour) / std::max(1.0, sum(colour_));
  for (int y = 0; y < inside_.rows; ++y)
    for (int x = 0; x < inside_.cols; ++x)
      if (gain * brightness(colour_.at<cv::Vec3b>(y, x)) >= templates::kMaySaturate)
        saturated.at<uchar>(y, x) = 0;
  cv::dilate(saturated, saturated, cv::Mat::ones(kBeside, kBeside, CV_8U));
  return inside_ & ~saturated;
}

}  // namespace mbncc::evidence
