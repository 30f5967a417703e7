// Rotational symmetry of an object, measured from what was learned.
#pragma once

#include "matching/evidence.hpp"
#include "matching/map_shape.hpp"

namespace mbncc {

/// Number of equal positions in a turn: 1 none, 2: 180 degrees, 3: 120 degrees ..., 0: round.
/// `own` is the learning picture that `object` (full resolution) was made from; `home` the pose of
/// the anchor in it. Outline and surface must both repeat, the latter but for shading: a wrong
/// "symmetric" would let a wrong angle pass.
int measure_symmetry(const PoseTemplate& object, const MapShape& shape, const SceneLevel& own,
                     const Pose2D& home);

}  // namespace mbncc
