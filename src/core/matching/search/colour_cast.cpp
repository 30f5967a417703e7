// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/colour_cast.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::search {
namespace {

constexpr double kLikely = 3;          // least log-odds of a detection used for the estimate
constexpr double kAlike = 0.06;        // [ln gain] largest difference of casts that agree
constexpr double kNoticeable = 0.055;  // [ln gain] least cast that is removed

std::optional<evidence::ColourCast> cast_at(const decision::Detection& detection,
                                            const prepared::Comparison& compared) {
  const templates::PoseTemplate& object = compared.object->views[detection.view_number].fine;
  const scene::SceneLevel& scene = compared.scene->levels[0];
  templates::SurfaceSample sample;
  object.surface.sample(scene.around(detection.pose, detection.scale * object.reach()),
                        detection.pose, sample, detection.scale);
  return evidence::local_cast(templates::block_sums(object.surface, sample));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

evidence::ColourCast median(const std::vector<evidence::ColourCast>& casts) {
  std::vector<double> blue, red;
  for (const auto& cast : casts) {
    blue.push_back(cast.blue);
    red.push_back(cast.red);
  }
  return {median(blue), median(red)};
}

}  // namespace

std::optional<evidence::ColourCast> colour_cast(
    const std::vector<prepared::Comparison>& compared,
    const std::vector<std::vector<decision::Detection>>& found) {
  std::vector<evidence::ColourCast> casts;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (!compared[i].object->coloured || found[i].empty()) continue;
    const decision::Detection& best =
        *std::max_element(found[i].begin(), found[i].end(),
                          [](const decision::Detection& a, const decision::Detection& b) {
                            return a.log_odds() < b.log_odds();
                          });
    if (best.log_odds() < kLikely) continue;
    if (const auto cast = cast_at(best, compared[i])) casts.push_back(*cast);
  }
  if (casts.size() < 2) return std::nullopt;
  const evidence::ColourCast middle = median(casts);
  const auto agreeing =
      std::count_if(casts.begin(), casts.end(), [&](const evidence::ColourCast& cast) {
        return std::hypot(cast.blue - middle.blue, cast.red - middle.red) <= kAlike;
      });
  const bool agreed = agreeing >= 2 && 2 * static_cast<std::size_t>(agreeing) > casts.size();
  if (!agreed || std::max(std::abs(middle.blue), std::abs(middle.red)) < kNoticeable)
    return std::nullopt;
  return middle;
}

cv::Mat without_cast(const cv::Mat& image, const evidence::ColourCast& cast) {
  const cv::Vec3d gains = cast.gains();
  cv::Mat balanced;
  cv::multiply(image, cv::Scalar(1 / gains[0], 1, 1 / gains[2]), balanced);
  return balanced;
}

}  // namespace mbncc::search
