// SPDX-License-Identifier: BSD-3-Clause
// Verification: refines poses at full resolution and tests alternatives.
#pragma once

#include <vector>

#include "matching/decision/detection.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/search/pose_hypothesis.hpp"

namespace mbncc::search {

/// Verifies the hypotheses `found` for a view and compares them with each other. Returns
/// detections, best first. Only poses that may be reported are refined.
std::vector<decision::Detection> verify(const prepared::PreparedObject& object,
                                        const prepared::PreparedView& view,
                                        const scene::SceneImage& scene,
                                        const std::vector<PoseHypothesis>& found);

}  // namespace mbncc::search
