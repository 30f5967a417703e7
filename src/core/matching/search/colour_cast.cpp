// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/colour_cast.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr double kLikely = 3;          // log-odds of a detection used for the estimate
constexpr double kAlike = 0.06;        // ln gain between those that agree
constexpr double kNoticeable = 0.055;  // ln gain from which on a picture is balanced

std::optional<ColourCast> cast_at(const Detection& detection, const ScenePicture& scene) {
  const PoseTemplate& object = detection.view->fine;
  SurfaceSample sample;
  scene.levels[0].prepare_around(detection.pose, object.reach());
  object.surface.sample(scene.levels[0], detection.pose, sample);
  return local_cast(block_sums(object.surface, sample));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

ColourCast median(const std::vector<ColourCast>& casts) {
  std::vector<double> blue, red;
  for (const auto& cast : casts) {
    blue.push_back(cast.blue);
    red.push_back(cast.red);
  }
  return {median(blue), median(red)};
}

}  // namespace

std::optional<ColourCast> colour_cast(const std::vector<std::vector<Detection>>& found,
                                      const ScenePicture& scene) {
  std::vector<ColourCast> casts;
  for (const auto& own : found)
    if (!own.empty() && own.front().object->coloured && own.front().log_odds >= kLikely)
      if (const auto cast = cast_at(own.front(), scene)) casts.push_back(*cast);
  if (casts.size() < 2) return std::nullopt;
  const ColourCast middle = median(casts);
  const auto agreeing = std::count_if(casts.begin(), casts.end(), [&](const ColourCast& cast) {
    return std::hypot(cast.blue - middle.blue, cast.red - middle.red) <= kAlike;
  });
  const bool agreed = agreeing >= 2 && 2 * static_cast<std::size_t>(agreeing) > casts.size();
  if (!agreed || std::max(std::abs(middle.blue), std::abs(middle.red)) < kNoticeable)
    return std::nullopt;
  return middle;
}

cv::Mat without_cast(const cv::Mat& picture, const ColourCast& cast) {
  const cv::Vec3d gains = cast.gains();
  cv::Mat balanced;
  cv::multiply(picture, cv::Scalar(1 / gains[0], 1, 1 / gains[2]), balanced);
  return balanced;
}

}  // namespace mbncc
