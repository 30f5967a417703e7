// SPDX-License-Identifier: BSD-3-Clause
// What tells, beside the evidence at a pose, how likely a detection is right.
#pragma once

#include "matching/decision/detection.hpp"

namespace mbncc {

/// Log-odds to add, fitted to what becomes of detections: the firmer the outline lies and the
/// farther other rotations are behind, the more, and the less, the farther this is behind another
/// instance, whose like it may be. The margins are those of margins.hpp. What was not examined may
/// lie better elsewhere.
double calibration(const Detection& detection, double angle_margin, double instance_margin);

/// Nearly certain, or likely and its texture is seen: mirror images and keys of another cut share
/// outline and material. More is asked of an outline that lies as well a few pixels off, as those
/// of mirror images do, and of what is behind another instance.
bool convincing(const Detection& detection, double instance_margin);

}  // namespace mbncc
