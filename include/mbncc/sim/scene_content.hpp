// SPDX-License-Identifier: BSD-3-Clause
// What a simulated scene shows: objects and the arm, at poses.
#pragma once

#include <cstdint>

#include "mbncc/geometry.hpp"

namespace mbncc::sim {

/// A flat textured object with an irregular outline.
struct SceneObject {
  std::uint64_t seed = 1;   ///< seed of outline and texture
  double diameter = 90;     ///< [px] of the excircle
  double elongation = 1.6;  ///< [1] approximate ratio of the longest to the shortest extent
};

/// An object at a pose: position of its outline's centroid, and angle relative to its drawing.
struct Placed {
  SceneObject object;
  Pose2D pose;
};

/// A tapered robot arm with a two-finger gripper, seen from above, that reaches into the image
/// from outside.
struct Arm {
  Pose2D grip;  ///< point between the finger tips; theta: direction in which the arm extends
  double opening = 60;  ///< [px] between the fingers
};

}  // namespace mbncc::sim
