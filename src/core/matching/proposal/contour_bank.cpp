// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/contour_bank.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "matching/scene/response_maps.hpp"
#include "matching/template/contour_template.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::proposal {
namespace {

constexpr int kOrientations = scene::ResponseMaps::kOrientations;

constexpr std::size_t kPoints = 64;  // number of contour points
constexpr double kSmallest = 20;     // [px at the coarse level] least diameter
constexpr double kThinnest = 2;      // [px at the coarse level] least mean width
constexpr double kLargest = 2048;    // [px at the coarse level] bounds rotations and margins
constexpr int kTopLevel = 4;
constexpr double kArcStep = 2;          // [px] that the rim moves per rotation step, ...
constexpr double kNarrowArcStep = 1.3;  // ... of objects narrower than a step
constexpr double kNarrow = 3.5;  // [px at the coarse level] mean width of narrow objects, at most

int orientation_of(float normal_x, float normal_y) {
  const double turns = std::atan2(normal_y, normal_x) / kPi;  // [half turns]
  const int bin = static_cast<int>(std::lround(turns * kOrientations));
  return ((bin % kOrientations) + kOrientations) % kOrientations;
}

/// Indices of the points ordered by their angle around the outline's centre. In this order, an
/// occluder covers a contiguous run even if it covers both sides of a narrow part, which lie far
/// apart along the outline.
std::vector<std::size_t> in_order_around(const templates::ContourTemplate& contour) {
  std::vector<std::size_t> order(contour.size());
  std::iota(order.begin(), order.end(), 0);
  const auto mean = [&](const auto& values) {
    return std::accumulate(values.begin(), values.begin() + contour.size(), 0.F) /
           static_cast<float>(contour.size());
  };
  const float x = mean(contour.x), y = mean(contour.y);
  const auto angle = [&](std::size_t i) { return std::atan2(contour.y[i] - y, contour.x[i] - x); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
  return order;
}

int coarse_level(double diameter, double width) {
  const double halvings = std::min(std::log2(diameter / kSmallest), std::log2(width / kThinnest));
  const double least_level = std::ceil(std::log2(diameter / kLargest));
  return std::clamp(static_cast<int>(std::max(std::floor(halvings), least_level)), 0, kTopLevel);
}

}  // namespace

ContourBank::ContourBank(const templates::MapGeometry& map, cv::Point2d anchor) {
  const templates::ContourTemplate whole(templates::ContourTemplate::edge_of(map, 0), anchor, 0,
                                         4000);
  const double reach = std::max(1.0, whole.radius());
  level_ = coarse_level(2 * reach, map.mean_width());
  const templates::ContourTemplate contour(templates::ContourTemplate::edge_of(map, level_), anchor,
                                           level_, kPoints);
  const std::vector<std::size_t> around = in_order_around(contour);
  radius_ = static_cast<int>(std::ceil(reach / (1 << level_))) + 1;
  const double rim = 2 * kPi * reach / (1 << level_);
  const double step = map.mean_width() < kNarrow * (1 << level_) ? kNarrowArcStep : kArcStep;
  const int count = std::max(12, static_cast<int>(std::ceil(rim / step)));
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * kPi * k / count;
    const Transform turned({0, 0, angle});
    Rotation rotation{wrap_angle(angle), {}};
    for (const std::size_t i : around) {
      const cv::Point2d at = turned({contour.x[i], contour.y[i]});
      const cv::Point2d normal = turned({contour.normal_x[i], contour.normal_y[i]});
      rotation.points.push_back(
          {cvRound(at.x), cvRound(at.y),
           orientation_of(static_cast<float>(normal.x), static_cast<float>(normal.y))});
    }
    rotations_.push_back(rotation);
  }
}

}  // namespace mbncc::proposal
