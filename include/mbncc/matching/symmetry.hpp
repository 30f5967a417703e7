// SPDX-License-Identifier: BSD-3-Clause
// Rotational symmetry of an object, measured in the image it was learned from.
#pragma once

#include "mbncc/object_model.hpp"

namespace mbncc {

/// Numbers of equivalent angles in a full turn: 1 none, 2, 3, 4 ..., 0 round.
struct MeasuredSymmetry {
  int certain = 1;   ///< outline and surface repeat within noise and shading
  int possible = 1;  ///< what an operator may declare: outline and surface nearly repeat, or the
                     ///< outline is round
};

/// Rotates the view about its centroid, aligns it with itself and compares outline and surface. A
/// wrong "certain" would accept a wrong angle, so a small mark, a notch or a highlight makes the
/// symmetry only "possible".
MeasuredSymmetry measure_symmetry(const View& view);

}  // namespace mbncc
