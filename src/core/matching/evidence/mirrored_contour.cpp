// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/mirrored_contour.hpp"

#include <algorithm>
#include <cmath>

#include "matching/evidence/contour_alignment.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kAlignmentSteps = 6;     // steps of a pixel that the mirrored outline may take, ...
constexpr int kSettling = 2;           // ... and the object's own
constexpr double kWorse = 0.2;         // difference in agreement that these do not make up for
constexpr double kTold = 0.006;        // difference in agreement of another outline in the lesson
constexpr double kLeastLimit = 0.005;  // agreement

templates::ContourTemplate mirrored(templates::ContourTemplate contour) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    contour.x[i] = -contour.x[i];
    contour.normal_x[i] = -contour.normal_x[i];
  }
  return contour;
}

/// The rotations about `home` with the best contour agreement, over a full turn, best first.
std::vector<templates::Candidate> best_turns(const templates::ContourTemplate& contour,
                                             const scene::PreparedPixels& pixels,
                                             const Pose2D& home, std::size_t most) {
  constexpr double kArc = 2;  // [px] at the rim between rotations
  const int count = std::max(24, static_cast<int>(std::ceil(2 * kPi * contour.radius() / kArc)));
  ContourAlignment agreement(contour, pixels);
  std::vector<templates::Candidate> turned;
  for (int k = 0; k < count; ++k) {
    const Pose2D pose{home.x, home.y, home.theta + 2 * kPi * k / count};
    turned.push_back({pose, 0, agreement.at(pose)});
  }
  templates::suppress(turned, {most,
                               templates::Suppression::kUnlimited,
                               templates::Suppression::kUnlimited,
                               {4 * kArc / 1.5, contour.radius()}});
  return turned;
}

}  // namespace

MirroredContour::MirroredContour(const templates::ContourTemplate& contour,
                                 const scene::SceneLevel& lesson, const Pose2D& home)
    : mirrored_(mirrored(contour)) {
  constexpr std::size_t kShifted = 8, kKept = 2;
  auto turned = best_turns(mirrored_, lesson.whole(), home, kShifted);
  for (auto& one : turned) one = shifted_onto_edges(mirrored_, lesson, one);
  templates::sort_by_value(turned);
  for (std::size_t k = 0; k < std::min(kKept, turned.size()); ++k)
    poses_.push_back(compose(inverse(home), turned[k].pose));
  const double surplus = better(contour, lesson, home, 1);
  usual_ = std::max(0.0, surplus);
  if (surplus < -kTold) limit_ = std::clamp(-surplus / 2, kLeastLimit, kMirrored);
}

double MirroredContour::better(const templates::ContourTemplate& contour,
                               const scene::SceneLevel& scene, const Pose2D& pose,
                               double scale) const {
  constexpr double kSlack = 24;  // [px] more than the motion of any outline
  const scene::PreparedPixels pixels = scene.around(pose, scale * contour.radius() + kSlack);
  const double own = ContourAlignment(contour, pixels, scale).aligned(pose, kSettling).agreement;
  ContourAlignment over(mirrored_, pixels, scale);
  double most = -1;
  for (const auto& there : poses_) {
    const Pose2D start = compose(pose, there);
    const double agreement = over.at(start);
    most = std::max(most, agreement > own - kWorse ? over.aligned(start, kAlignmentSteps).agreement
                                                   : agreement);
  }
  return most - own - usual_;
}

}  // namespace mbncc::evidence
