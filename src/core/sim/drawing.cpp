// SPDX-License-Identifier: BSD-3-Clause
#include "sim/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/outline.hpp"
#include "sim/texture.hpp"

namespace mbncc::sim {
namespace {

constexpr double kShadowStrength = 0.4;

/// Part of the image that the drawing at `pose` can touch, grown by `margin`.
cv::Rect footprint(const Drawing& drawing, const Pose2D& pose, int margin, cv::Size image) {
  const double right = drawing.cover.cols - drawing.origin.x;
  const double bottom = drawing.cover.rows - drawing.origin.y;
  cv::Point2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const double x : {-drawing.origin.x, right}) {
    for (const double y : {-drawing.origin.y, bottom}) {
      const cv::Point2d corner = transform(pose, cv::Point2d(x, y) / drawing.scale);
      low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
      high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
  }
  const cv::Rect box(cv::Point(cvFloor(low.x) - margin, cvFloor(low.y) - margin),
                     cv::Point(cvCeil(high.x) + margin + 1, cvCeil(high.y) + margin + 1));
  return box & cv::Rect({0, 0}, image);
}

/// Resamples `source` at `pose` on a grid that is finer than the image by the drawing's scale, then
/// averages over the area of each pixel.
cv::Mat resample(const cv::Mat& source, const Drawing& drawing, const Pose2D& pose,
                 const cv::Rect& where) {
  const double s = drawing.scale, c = std::cos(pose.theta), sn = std::sin(pose.theta);
  // Sample u of the fine grid lies at image coordinate where.x + (u + 0.5) / s - 0.5.
  const cv::Point2d first(where.x + 0.5 / s - 0.5, where.y + 0.5 / s - 0.5);
  const cv::Point2d start = rotate(first - pose.position(), -pose.theta) * s + drawing.origin;
  const cv::Matx23d to_source(c, sn, start.x, -sn, c, start.y);
  cv::Mat fine, result;
  const int factor = cvRound(s);
  cv::warpAffine(source, fine, to_source, where.size() * factor,
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  cv::resize(fine, result, where.size(), 0, 0, cv::INTER_AREA);
  return result;
}

cv::Mat three_channels(const cv::Mat& grey) {
  cv::Mat result;
  cv::merge(std::vector<cv::Mat>(3, grey), result);
  return result;
}

/// Sets the pixels of `cover` whose centres lie inside `outline` (drawing coordinates) to 1.
/// cv::fillPoly also paints the outline's own pixels, which would move the centroid.
void fill_inside(const std::vector<cv::Point2d>& outline, cv::Mat& cover) {
  for (int row = 0; row < cover.rows; ++row) {
    std::vector<double> crossings;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const cv::Point2d a = outline[i], b = outline[(i + 1) % outline.size()];
      if ((a.y <= row) != (b.y <= row))
        crossings.push_back(a.x + (row - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      cover.row(row).colRange(cvCeil(crossings[i]), cvFloor(crossings[i + 1]) + 1).setTo(1);
  }
}

}  // namespace

Drawing draw_object(const SceneObject& object) {
  Drawing drawing;
  auto outline = object_outline(object);
  double reach = 0;
  for (const auto& point : outline) reach = std::max({reach, std::abs(point.x), std::abs(point.y)});
  const int half = cvCeil((reach + 2) * drawing.scale);
  const cv::Size size(2 * half + 1, 2 * half + 1);
  drawing.origin = cv::Point2d(half, half);
  for (auto& point : outline) point = drawing.origin + point * drawing.scale;
  drawing.cover = cv::Mat::zeros(size, CV_32FC1);
  fill_inside(outline, drawing.cover);
  // The centroid of the rasterised shape differs from that of the outline by a fraction of a
  // drawing pixel.
  const cv::Moments moments = cv::moments(drawing.cover);
  drawing.origin = {moments.m10 / moments.m00, moments.m01 / moments.m00};
  drawing.colour = object_texture(size, drawing.scale, object.seed);
  drawing.colour.setTo(cv::Scalar::all(0), drawing.cover == 0);
  return drawing;
}

cv::Mat coverage(const Drawing& drawing, const Pose2D& pose, cv::Size image, cv::Rect& where) {
  where = footprint(drawing, pose, 0, image);
  return where.empty() ? cv::Mat() : resample(drawing.cover, drawing, pose, where);
}

void composite(const Drawing& drawing, const Pose2D& pose, double shadow_sigma, cv::Mat& image) {
  const int margin = cvCeil(3 * shadow_sigma);
  const cv::Rect where = footprint(drawing, pose, margin, image.size());
  if (where.empty()) return;
  const cv::Mat cover = resample(drawing.cover, drawing, pose, where);
  const cv::Mat colour = resample(drawing.colour, drawing, pose, where);
  const cv::Matx23d beside(1, 0, 0.5 * shadow_sigma, 0, 1, 0.8 * shadow_sigma);
  cv::Mat shadow;
  cv::warpAffine(cover, shadow, beside, cover.size());
  cv::GaussianBlur(shadow, shadow, {}, shadow_sigma);
  cv::Mat part = image(where);
  const cv::Mat kept = (1 - kShadowStrength * shadow).mul(1 - cover);
  cv::Mat(part.mul(three_channels(kept)) + colour).copyTo(part);
}

}  // namespace mbncc::sim
