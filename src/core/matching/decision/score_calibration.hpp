// SPDX-License-Identifier: BSD-3-Clause
// Calibration of the score by competitors and by the fit of the outline nearby.
#pragma once

#include "matching/decision/detection.hpp"

namespace mbncc::decision {

/// Log-odds to add, fitted to the correctness of detections. They increase with the distinctness of
/// the outline's fit and with the margin to other rotations, and decrease with the lead of another
/// instance. The margins are those of margins.hpp. A detection whose outline was not examined is
/// treated as fitting better elsewhere.
double calibration(const Detection& detection, double angle_margin, double instance_margin);

}  // namespace mbncc::decision
