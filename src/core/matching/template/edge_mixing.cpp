// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/edge_mixing.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::templates {
namespace {

constexpr float kBackground = 0.12f;  // largest share of the object in a background pixel

/// Blur [px, level 0] that a map's edge has in a level: lens, pixels, smoothing.
double blur_of(int level) {
  constexpr double kLens = 0.8;
  const double smoothing = (level == 0 ? 0.9 : 0.67) * (1 << level);
  return std::hypot(kLens, smoothing);
}

}  // namespace

AlphaMatte::AlphaMatte(const MapGeometry& map, int level)
    : side_(1 << level),
      room_(static_cast<int>(std::ceil(3 * blur_of(level)))),
      share_(map.blurred(blur_of(level), room_)) {}

EdgeMixing AlphaMatte::at(cv::Point pixel) const {
  const cv::Point middle = pixel + cv::Point(room_, room_);
  const cv::Rect picture({0, 0}, share_.size());
  const float own = share_.at<float>(middle);
  if (own <= kBackground) return {own, {cv::Point2f(pixel), cv::Point2f(pixel)}};
  const int reach = 4 * side_ + 3, step = std::max(1, side_ / 2);
  EdgeMixing mixture;
  std::array<double, 2> nearest{1e9, 1e9};
  std::array<cv::Point, 2> offsets;
  for (int k = 0; k < 2; ++k)
    for (int y = -reach; y <= reach; y += step)
      for (int x = -reach; x <= reach; x += step) {
        const cv::Point offset(x, y);
        const double distance = cv::norm(offset);
        if (distance >= nearest[k] || !picture.contains(middle + offset)) continue;
        if (share_.at<float>(middle + offset) > kBackground) continue;
        if (k == 1 && offset.dot(offsets[0]) > -0.3 * distance * nearest[0]) continue;
        nearest[k] = distance;
        offsets[k] = offset;
      }
  if (nearest[0] > reach * 2) return mixture;
  if (nearest[1] > nearest[0] + 2 * side_) offsets[1] = offsets[0];
  mixture.share = std::min(own, 1.f);
  for (int k = 0; k < 2; ++k) mixture.beyond[k] = cv::Point2f(pixel + offsets[k]);
  return mixture;
}

}  // namespace mbncc::templates
