// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/outline_contrast.hpp"

#include <algorithm>
#include <cmath>

#include "matching/evidence/gain_offset.hpp"
#include "matching/template/colours_beside.hpp"

namespace mbncc::evidence {
namespace {

float difference(const cv::Vec3f& a, const cv::Vec3f& b) {
  return static_cast<float>(cv::norm(a - b, cv::NORM_INF));
}

/// Length [px] of the longest connected part of a contour of one or several outlines in which
/// `holds` is set.
double longest_part(const templates::ContourTemplate& contour, const std::vector<char>& holds) {
  const std::size_t count = holds.size();
  const auto apart = [&](std::size_t a, std::size_t b) {
    return std::hypot(contour.x[a] - contour.x[b], contour.y[a] - contour.y[b]);
  };
  double around = apart(0, count - 1);
  for (std::size_t k = 1; k < count; ++k) around += apart(k - 1, k);
  const double step = around / static_cast<double>(count);
  double longest = 0;
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    for (end = first + 1; end < count && apart(end - 1, end) <= 3 * step;) ++end;
    double part = 0;  // twice around the outline, because a part may begin before its first point
    for (std::size_t k = 0; k < 2 * (end - first); ++k) {
      part = holds[first + k % (end - first)] ? part + step : 0;
      longest = std::max(longest, std::min(part, step * static_cast<double>(end - first)));
    }
  }
  return longest;
}

}  // namespace

OutlineContrast::OutlineContrast(const templates::ContourTemplate& contour,
                                 const scene::SceneLevel& lesson, const Pose2D& home, double area)
    : side_(std::sqrt(area)) {
  const cv::Mat& colours = lesson.whole().colour;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const auto in = colour_beside(contour, k, -templates::kBeside, colours, home, 1);
    const auto out = colour_beside(contour, k, templates::kBeside, colours, home, 1);
    inside_.push_back(in.value_or(cv::Vec3f()));
    contrast_.push_back(in && out ? difference(*in, *out) : 0);
  }
}

MissingContrast OutlineContrast::missing(const scene::SceneLevel& scene,
                                         const templates::PoseTemplate& object,
                                         const templates::PoseSample& sample, const Pose2D& pose,
                                         double scale) const {
  constexpr float kLeast = 30;  // [grey levels] contrast
  // As parts of that contrast: differences of the two sides, and of one side from its expected
  // colour. A background is less uniform than an object near its outline.
  constexpr float kSame = 0.15F, kOwn = 0.2F, kSameGround = 0.35F, kGround = 0.5F;
  const templates::ContourTemplate& contour = object.contour;
  if (contour.size() == 0) return {};
  const scene::PreparedPixels image =
      scene.around(pose, scale * object.reach() + templates::kBeside);
  const GainOffset light = light_on(object.surface, sample.surface);
  const cv::Vec3f ground = background_colour(contour, scene, pose, scale);
  std::vector<char> continued(contour.size(), 0), absent(contour.size(), 0);
  for (std::size_t k = 0; k < contour.size(); ++k) {
    if (sample.contour.seen[k] == 0 || templates::is_clear(sample.contour.response[k])) continue;
    const auto in = colour_beside(contour, k, -templates::kBeside, image.colour, pose, scale);
    const auto out = colour_beside(contour, k, templates::kBeside, image.colour, pose, scale);
    if (!in || !out) continue;
    const cv::Vec3f own(light.of(inside_[k][0]), light.of(inside_[k][1]), light.of(inside_[k][2]));
    const float across = difference(*in, *out);
    const float learned = static_cast<float>(light.factor) * contrast_[k];
    continued[k] =
        learned > kLeast && across < kSame * learned && difference(*in, own) < kOwn * learned;
    const float expected = difference(own, ground);
    absent[k] = expected > kLeast && across < kSameGround * expected &&
                difference(*out, ground) < kGround * expected &&
                difference(*in, ground) < kGround * expected;
  }
  return {longest_part(contour, continued) / side_, longest_part(contour, absent) / side_};
}

}  // namespace mbncc::evidence
