// SPDX-License-Identifier: BSD-3-Clause
// Seeded outlines of flat objects.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/sim/scene_content.hpp"

namespace mbncc::sim {

/// Closed outline [px] about its own centroid, of the object's diameter and elongation: a shard, a
/// pebble, a bracket, a hammer or a spanner.
std::vector<cv::Point2d> object_outline(const SceneObject& object);

}  // namespace mbncc::sim
