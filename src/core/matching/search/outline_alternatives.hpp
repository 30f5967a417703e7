// SPDX-License-Identifier: BSD-3-Clause
// Alternatives to a pose whose outline fits better: mirrored, nearby or torn. A surface that
// contradicts one decides against it, because lines of a print or of a neighbour form outlines,
// too.
#pragma once

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"

namespace mbncc::search {

/// A view at a pose in an image at full resolution, `scale` times as large as learned.
struct ViewInImage {
  const prepared::PreparedView& view;
  const scene::SceneImage& scene;
  Pose2D pose;
  double scale;

  const scene::SceneLevel& level() const { return scene.levels[0]; }
};

/// [-2..2] Advantage in agreement of the mirrored outline; 0 if the surface contradicts it. If it
/// is large, the object lies on its other side, or its mirror image lies there. 0 for a round
/// object, whose outline is its own mirror image.
double mirrored_advantage(const ViewInImage& found);

/// [-2..2] Advantage in agreement of the outline at a nearby place, see alternative_elsewhere(); 0
/// if the surface contradicts it.
double nearby_advantage(const ViewInImage& found);

/// Whether the rows of the image are displaced at the pose, or only those of the object, if the
/// background did not move.
bool is_torn(const ViewInImage& found);

}  // namespace mbncc::search
