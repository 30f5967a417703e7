// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/interior_edges.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/gradient_orientation.hpp"
#include "matching/evidence/differing_groups.hpp"
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

}  // namespace

InteriorEdges::InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map,
                             cv::Point2d anchor)
    : lesson_(lesson, map, anchor, kRim), edges_(lesson.whole().edges(lesson_.box).clone()) {}

double InteriorEdges::difference(const scene::SceneLevel& scene,
                                 const templates::ContourTemplate& contour,
                                 const templates::ContourSample& outline, const Pose2D& pose,
                                 double scale) const {
  constexpr double kLeastFound = 0.5;  // least part of the outline found beside a group
  if (lesson_.area == 0) return 0;
  const scene::PreparedPixels image = scene.around(pose, scale * lesson_.reach + 2 * kSlack);
  const LessonPixels pixels(lesson_, image.size(), pose, scale);
  const Seen seen{pixels.read(image.colour, cv::INTER_NEAREST),
                  pixels.read(image.edges, cv::INTER_NEAREST), pixels.inside()};
  const cv::Mat where = without_highlights(seen) & seen.inside;
  const cv::Mat differing = only_in(edges_, pose.theta, seen.edges, where) |
                            only_in(seen.edges, -pose.theta, edges_, where);
  const auto found = [&](const cv::Point2d& at) {
    return templates::contour_found_beside(contour, outline, at - lesson_.anchor) > kLeastFound;
  };
  return largest_groups(differing, where, kSlack, found).enclosed / std::sqrt(lesson_.area);
}

/// CV_8UC1: 255 inside the outline, except near pixels that are saturated in the image although the
/// object would not saturate in this light.
cv::Mat InteriorEdges::without_highlights(const Seen& seen) const {
  const cv::Scalar least = cv::Scalar::all(templates::kSaturated), most = cv::Scalar::all(255);
  const cv::Mat shown = lesson_.inside & seen.inside;
  cv::Mat saturated;
  cv::inRange(seen.colour, least, most, saturated);
  saturated &= shown;
  const int all = cv::countNonZero(saturated);
  const cv::Mat open = shown & ~saturated;
  const int shown_well = cv::countNonZero(open);
  if (all == 0 || shown_well <= all) return lesson_.inside;
  const auto sum = [&](const cv::Mat& colour) {
    const cv::Scalar mean = cv::mean(colour, open);
    return shown_well * (mean[0] + mean[1] + mean[2]);
  };
  const double gain = sum(seen.colour) / std::max(1.0, sum(lesson_.colour));
  for (int y = 0; y < lesson_.inside.rows; ++y)
    for (int x = 0; x < lesson_.inside.cols; ++x)
      if (gain * brightness(lesson_.colour.at<cv::Vec3b>(y, x)) >= templates::kMaySaturate)
        saturated.at<uchar>(y, x) = 0;
  cv::dilate(saturated, saturated, cv::Mat::ones(kBeside, kBeside, CV_8U));
  return lesson_.inside & ~saturated;
}

}  // namespace mbncc::evidence
