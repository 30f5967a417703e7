#include "matching/symmetry.hpp"

#include <algorithm>

#include "matching/climb.hpp"

namespace mbncc {
namespace {

constexpr double kMinOverlap = 0.97;    // of the map with itself turned
constexpr double kMaxDifference = 0.3;  // of the texture's energy, ...
constexpr double kVisible = 15;         // [grey^2] ... but no more than this
constexpr double kNoise = 5;            // [grey^2] of the difference of two pictures

bool repeats(const PoseTemplate& object, const MapShape& shape, const SceneLevel& own,
             const Pose2D& home, double angle) {
  constexpr int kIterations = 4;
  const Pose2D start{home.x, home.y, home.theta + angle};
  if (overlap(shape, home, shape, start) < kMinOverlap) return false;
  const Pose2D pose = climb(object, own, start, kIterations).pose;
  if (overlap(shape, home, shape, pose) < kMinOverlap) return false;
  SurfaceSample sample;
  own.prepare_around(pose, object.reach());
  object.surface.sample(own, pose, sample);
  const double energy = object.surface.mean_projected_energy();
  return object.surface.difference(sample).rest <
         std::min(kMaxDifference * energy, kVisible) + kNoise;
}

/// Gloss may spoil a few of the rotations of a round object.
bool is_round(const PoseTemplate& object, const MapShape& shape, const SceneLevel& own,
              const Pose2D& home) {
  constexpr int kRotations = 23, kEnough = 12;
  int equal = 0;
  for (int k = 1; k < kRotations && equal + kRotations - k >= kEnough; ++k)
    equal += repeats(object, shape, own, home, 2 * kPi * k / kRotations);
  return equal >= kEnough;
}

bool has_order(const PoseTemplate& object, const MapShape& shape, const SceneLevel& own,
               const Pose2D& home, int order) {
  for (int k = 1; k <= order / 2; ++k)
    if (!repeats(object, shape, own, home, 2 * kPi * k / order)) return false;
  return true;
}

}  // namespace

int measure_symmetry(const PoseTemplate& object, const MapShape& shape, const SceneLevel& own,
                     const Pose2D& home) {
  if (is_round(object, shape, own, home)) return 0;
  for (const int order : {12, 10, 9, 8, 7, 6, 5, 4, 3, 2})
    if (has_order(object, shape, own, home, order)) return order;
  return 1;
}

}  // namespace mbncc
