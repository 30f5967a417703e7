// SPDX-License-Identifier: BSD-3-Clause
// Calibration of the score by competitors, by the fit of the outline nearby and by what is beside
// it.
#pragma once

#include "matching/decision/detection.hpp"

namespace mbncc::decision {

/// Log-odds to add, fitted to the correctness of detections. They increase with the distinctness of
/// the outline's fit and with the margin to other rotations, and decrease with the lead of another
/// instance and with the part of the outline beyond which the object goes on. The margins are those
/// of margins.hpp. A detection whose outline was not examined is treated as fitting better
/// elsewhere.
double calibration(const Detection& detection, double angle_margin, double instance_margin);

}  // namespace mbncc::decision
