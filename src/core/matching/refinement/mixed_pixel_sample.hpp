// SPDX-License-Identifier: BSD-3-Clause
// Colours of a small object in a picture, after subtraction of the background at its edge.
#pragma once

#include <vector>

#include "matching/refinement/mixed_pixel_model.hpp"

namespace mbncc::refinement {

struct MixedPixelSample {
  std::vector<float> values;  ///< per axis of colour and point; 0 outside of the picture
  std::vector<float> inside;  ///< per point; 1: in the picture with its background, 0: outside
};

/// Reads a picture that has been prepared around `pose`.
void read_rendering(const MixedPixelModel& object, const scene::SceneLevel& scene,
                    const Pose2D& pose, MixedPixelSample& reading);

}  // namespace mbncc::refinement
