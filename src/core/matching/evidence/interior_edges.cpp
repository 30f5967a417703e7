// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/interior_edges.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/gradient_orientation.hpp"
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

/// Offsets to a pixel and those within kSlack of it, nearest first.
std::vector<cv::Point> places_around() {
  std::vector<cv::Point> places;
  for (int y = -kSlack; y <= kSlack; ++y)
    for (int x = -kSlack; x <= kSlack; ++x) places.emplace_back(x, y);
  std::stable_sort(places.begin(), places.end(),
                   [](const cv::Point& a, const cv::Point& b) { return a.dot(a) < b.dot(b); });
  return places;
}

/// Edge image with a margin, in which edges near a pixel are looked up.
class EdgesAround {
 public:
  explicit EdgesAround(const cv::Mat& edges) {
    cv::copyMakeBorder(edges, edges_, kSlack, kSlack, kSlack, kSlack,
                       cv::BORDER_CONSTANT | cv::BORDER_ISOLATED);
    for (const auto& by : places_around())
      offsets_.push_back(static_cast<std::ptrdiff_t>(by.y) * edges_.cols + by.x);
  }

  /// Whether there is an edge of this direction near (x, y).
  bool has_along(int x, int y, const cv::Vec2f& direction) const {
    const auto* at = edges_.ptr<Vector>(y + kSlack) + x + kSlack;
    return std::any_of(offsets_.begin(), offsets_.end(), [&](std::ptrdiff_t offset) {
      return dot(at[offset], direction) > kFaint * imaging::kEdgeScale;
    });
  }

 private:
  cv::Mat edges_;  // continuous
  std::vector<std::ptrdiff_t> offsets_;
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

/// Whether most of the contour is found beside `at` [px] relative to the anchor.
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
                                 const templates::ContourTemplate& contour, const Pose2D& pose,
                                 double scale) const {
  const int area = cv::countNonZero(inside_);
  if (area == 0) return 0;
  const scene::PreparedPixels image =
      scene.around(pose, scale * std::max(reach_, contour.radius()) + kSlack);
  const Seen seen = at_pose(image, pose, scale);
  const cv::Mat where = without_highlights(seen) & seen.inside;
  const cv::Mat pixels = only_in(edges_, pose.theta, seen.edges, where) |
                         only_in(seen.edges, -pose.theta, edges_, where);
  int largest = 0;
  templates::ContourSample outline;
  for (const Group& group : groups_of(pixels, where)) {
    if (group.reaches || group.size <= largest) continue;
    if (outline.response.empty())
      templates::read_contour(contour, image.edges, pose, 0, outline, scale);
    if (outline_is_found_beside(group.centre - anchor_, contour, outline)) largest = group.size;
  }
  return largest / std::sqrt(area);
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
