// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/mirrored_contour.hpp"

#include <algorithm>

#include "matching/evidence/closest_points.hpp"
#include "matching/evidence/contour_alignment.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kAlignmentSteps = 6;     // steps of 1 px to align the mirrored outline, ...
constexpr int kOwnAlignmentSteps = 2;  // ... and the object's own outline
constexpr double kWorse = 0.2;  // difference in agreement that these steps cannot make up for
constexpr double kSame = 3;     // [px] closer poses are duplicates
// [agreement] least deficit of a different outline in the lesson
constexpr double kMinDeficit = 0.006;
constexpr double kLeastLimit = 0.005;  // [agreement] lower bound of limit()

templates::ContourTemplate mirrored(templates::ContourTemplate contour) {
  contour.mirror();
  return contour;
}

/// The poses of `contour` relative to `fixed` that iterated closest points reach from rotations
/// about the anchor, best first.
std::vector<Pose2D> best_overlays(const templates::ContourTemplate& contour,
                                  const templates::ContourTemplate& fixed) {
  constexpr int kStarts = 24;  // rotations
  constexpr std::size_t kKept = 4;
  const ClosestPoints closest(fixed);
  std::vector<templates::Candidate> laid;
  for (int k = 0; k < kStarts; ++k) {
    const RegisteredContour one = closest.align(contour, {0, 0, 2 * kPi * k / kStarts});
    laid.push_back({one.pose, 0, one.covered});
  }
  templates::keep_distinct(laid, kKept, {kSame, fixed.radius()});
  std::vector<Pose2D> poses;
  for (const auto& one : laid) poses.push_back(one.pose);
  return poses;
}

}  // namespace

MirroredContour::MirroredContour(const templates::ContourTemplate& contour,
                                 const scene::SceneLevel& lesson, const Pose2D& home)
    : mirrored_(mirrored(contour)), poses_(best_overlays(mirrored_, contour)) {
  double surplus = -1;
  for (const auto& one : alternatives(contour, lesson, home, 1))
    surplus = std::max(surplus, one.advantage);
  usual_ = std::max(0.0, surplus);
  if (surplus < -kMinDeficit) limit_ = std::clamp(-surplus / 2, kLeastLimit, kMirrored);
}

std::vector<MirroredContour::Alternative> MirroredContour::alternatives(
    const templates::ContourTemplate& contour, const scene::SceneLevel& scene, const Pose2D& pose,
    double scale) const {
  constexpr double kSlack = 10;  // [px] more than the reach of alignment and edge search
  const auto around = [&](const Pose2D& place) {
    return scene.around(place, scale * contour.radius() + kSlack);
  };
  const double own =
      ContourAlignment(contour, around(pose), scale).aligned(pose, kOwnAlignmentSteps).agreement;
  std::vector<Alternative> found;
  for (const auto& one : poses_) {
    const Pose2D start = compose(pose, {scale * one.x, scale * one.y, one.theta});
    ContourAlignment over(mirrored_, around(start), scale);
    AlignedContourPose there{start, over.at(start)};
    if (there.agreement > own - kWorse) there = over.aligned(start, kAlignmentSteps);
    found.push_back({there.pose, there.agreement - own - usual_});
  }
  return found;
}

}  // namespace mbncc::evidence
