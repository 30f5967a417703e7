// SPDX-License-Identifier: BSD-3-Clause
// Alternatives to a pose whose outline fits better: mirrored or torn.
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

/// [0..2] Largest advantage in agreement of the mirrored outline that exceeds its limit() and that
/// the surface does not contradict, because lines of a print form outlines, too; 0: none. The
/// object then lies on its other side, or its mirror image lies there. 0 for a round object, whose
/// outline is its own mirror image.
double mirrored_advantage(const ViewInImage& found);

/// Whether the rows of the image are displaced at the pose, or only those of the object, if the
/// background did not move.
bool is_torn(const ViewInImage& found);

}  // namespace mbncc::search
