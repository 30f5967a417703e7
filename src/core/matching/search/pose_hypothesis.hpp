// SPDX-License-Identifier: BSD-3-Clause
// A pose hypothesis at full resolution, aligned by contour and surface.
#pragma once

#include <vector>

#include "matching/evidence/evidence.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/candidate.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::search {

/// Log-odds below which no pose ever became a detection, so it is not refined.
constexpr double kMinOddsToRefine = -4;

/// A pose at full resolution with the evidence for it.
struct PoseHypothesis {
  Pose2D pose;
  evidence::Evidence evidence;
  double odds = 0;       ///< log-odds that the object lies here
  bool aligned = false;  ///< from several starts
};

/// The pose reached by alignment of `object`, a template of the view, from `start` [px at its
/// level].
PoseHypothesis aligned_from(const prepared::PreparedView& view,
                            const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                            const Pose2D& start, int iterations);

/// The evidence for a pose without alignment.
PoseHypothesis score_as_is(const prepared::PreparedView& view, const scene::SceneImage& scene,
                           const Pose2D& pose, double scale = 1);

/// The better of two poses at one place, by light-independent features only.
PoseHypothesis better_rotation(const PoseHypothesis& a, const PoseHypothesis& b);

/// The best pose reached by alignment from `pose` and from slightly rotated starts.
PoseHypothesis multistart_align(const prepared::PreparedView& view, const scene::SceneImage& scene,
                                const Pose2D& pose);

/// The hypotheses of sorted candidates at full resolution: the best of those above `promising`
/// log-odds are aligned from several starts, the others scored as they are.
std::vector<PoseHypothesis> hypotheses(const prepared::PreparedView& view,
                                       const scene::SceneImage& scene,
                                       const std::vector<templates::Candidate>& candidates,
                                       double promising);

}  // namespace mbncc::search
