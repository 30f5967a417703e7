// SPDX-License-Identifier: BSD-3-Clause
#include "library/model_difference.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mbncc::library {
namespace {

bool differ(const Pose2D& a, const Pose2D& b) {
  return a.x != b.x || a.y != b.y || a.theta != b.theta;
}

bool differ(const std::optional<Grasp>& a, const std::optional<Grasp>& b) {
  if (a.has_value() != b.has_value()) return true;
  return a && (a->position != b->position || a->orientation != b->orientation);
}

// NaN means unknown, so two NaNs are equal.
bool differ(double a, double b) {
  return a != b && !(std::isnan(a) && std::isnan(b));
}

bool differ(const cv::Mat& a, const cv::Mat& b) {
  return a.size() != b.size() || a.type() != b.type() || cv::norm(a, b, cv::NORM_INF) != 0;
}

bool differ(const View& a, const View& b) {
  return a.origin != b.origin || a.image_size != b.image_size || differ(a.reference, b.reference) ||
         differ(a.map, b.map) || differ(a.template_image, b.template_image);
}

}  // namespace

bool moves_poses(const ObjectModel& before, const ObjectModel& after) {
  return !std::equal(before.views.begin(), before.views.end(), after.views.begin(),
                     after.views.end(),
                     [](const View& a, const View& b) { return !differ(a, b); }) ||
         before.symmetry != after.symmetry || differ(before.grasp, after.grasp) ||
         differ(before.object_height, after.object_height) ||
         differ(before.metres_per_pixel, after.metres_per_pixel);
}

ObjectModel deep_copy(const ObjectModel& model) {
  ObjectModel copy = model;
  for (auto& view : copy.views) {
    view.template_image = view.template_image.clone();
    view.map = view.map.clone();
  }
  return copy;
}

}  // namespace mbncc::library
