// SPDX-License-Identifier: BSD-3-Clause
// What similar places elsewhere in the image cost a detection.
#pragma once

#include <vector>

namespace mbncc::decision {

/// Log-odds penalty for similar places elsewhere, except other instances. `odds` are those of
/// the best detections of different places, best first.
double clutter_penalty(const std::vector<double>& odds);

}  // namespace mbncc::decision
