// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "matching/prepared/self_comparison.hpp"

namespace mbncc {
namespace {

// Limits of a certain symmetry.
constexpr double kSureOutline = 0.03;        // [radii] depth of the outline's difference, ...
constexpr double kMapEdgeError = 2;          // [px] ... at least the error of a map's edge, ...
constexpr double kSmallMapEdgeError = 0.12;  // [radii] ... limited for small objects
constexpr double kSureMark = 4.5;            // [grey levels] in addition to noise
constexpr double kSamplingError = 0.06;      // of the texture: error of its edges by sampling

// Limits of a near symmetry.
constexpr double kNearOverlap = 0.9;
constexpr double kRoundOverlap = 0.94;  // a hexagon turned by half a side has 0.93
constexpr double kNearOutline = 0.2;    // of the radius
constexpr double kNearMark = 40;        // [grey levels], or ...
constexpr double kNearRest = 0.35;      // ... of the texture

/// Whether a near symmetry of this order is proposed. A hexagon nearly has those left out.
constexpr bool is_proposed(int order) {
  return order <= 6 && order != 5;
}

enum class Repeats { kNot, kNearly, kSurely };

class Measurement {
 public:
  explicit Measurement(const View& view) : view_(view), map_(view) {}

  /// Whether the map covers itself after all rotations by multiples of 1/`order` turn. Inverse
  /// rotations give the same overlap.
  bool covers_itself(int order, double least_overlap) const {
    for (int k = 1; k <= order / 2; ++k)
      if (map_.overlap(angle(k, order)) < least_overlap) return false;
    return true;
  }

  /// The weakest result for outline and surface over these rotations. Stops as soon as it is below
  /// `least`.
  Repeats with_order(int order, Repeats least = Repeats::kNearly) {
    Repeats weakest = Repeats::kSurely;
    for (int k = 1; k <= order / 2 && weakest >= least; ++k)
      weakest = std::min(weakest, after(angle(k, order)));
    return weakest;
  }

 private:
  static double angle(int k, int order) { return 2 * kPi * k / order; }

  Repeats after(double angle) {
    if (!surface_) surface_.emplace(view_, map_);
    const prepared::TurnDifference difference = surface_->difference(angle);
    if (is_sure(difference)) return Repeats::kSurely;
    return is_near(difference) ? Repeats::kNearly : Repeats::kNot;
  }

  bool is_sure(const prepared::TurnDifference& difference) const {
    const double radius = map_.radius();
    // The edge of a map is inaccurate by a fraction of a pixel, which matters more for small
    // objects.
    const double overlap_tolerance = std::clamp(0.8 / radius, 0.03, 0.05);
    const double drawn = kSamplingError * surface_->texture();
    const double edge_error = std::min(kMapEdgeError, kSmallMapEdgeError * radius);
    return difference.overlap >= 1 - overlap_tolerance &&
           difference.outline <= std::max(edge_error, kSureOutline * radius) &&
           difference.mark <= std::hypot(kSureMark, surface_->noise_of_mark(), drawn);
  }

  bool is_near(const prepared::TurnDifference& difference) const {
    return difference.overlap >= kNearOverlap &&
           difference.outline <= kNearOutline * map_.radius() &&
           (difference.mark <= kNearMark || difference.rest <= kNearRest * surface_->texture());
  }

  const View& view_;
  prepared::CentredMap map_;
  std::optional<prepared::SelfComparison> surface_;
};

}  // namespace

MeasuredSymmetry measure_symmetry(const View& view) {
  constexpr int kAnyOrder = 23;          // order that no polygon has
  constexpr double kOverlapGain = 0.03;  // overlap gained by the best shift
  Measurement measurement(view);
  if (measurement.covers_itself(kAnyOrder, kRoundOverlap)) {
    // Only the operator can decide whether a difference of the surface is a mark, an oblique side
    // or gloss.
    const Repeats round = measurement.with_order(kAnyOrder, Repeats::kSurely);
    return {round == Repeats::kSurely ? 0 : 1, 0};
  }
  MeasuredSymmetry symmetry;
  for (const int order : {12, 10, 9, 8, 7, 6, 5, 4, 3, 2}) {
    if (!measurement.covers_itself(order, kNearOverlap - kOverlapGain)) continue;
    const Repeats repeats = measurement.with_order(order);
    if (repeats == Repeats::kNearly && is_proposed(order))
      symmetry.possible = std::max(symmetry.possible, order);
    if (repeats != Repeats::kSurely) continue;
    symmetry.certain = order;
    break;
  }
  symmetry.possible = std::max(symmetry.possible, symmetry.certain);
  return symmetry;
}

}  // namespace mbncc
