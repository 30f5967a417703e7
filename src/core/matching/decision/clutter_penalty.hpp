// SPDX-License-Identifier: BSD-3-Clause
// Penalty of a detection for similar places elsewhere in the image.
#pragma once

#include <vector>

namespace mbncc::decision {

/// Log-odds penalty for similar places elsewhere, except other instances. `odds`: log-odds of the
/// best detection at each place, best first.
double clutter_penalty(const std::vector<double>& odds);

}  // namespace mbncc::decision
