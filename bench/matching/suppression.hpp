// SPDX-License-Identifier: BSD-3-Clause
// Keeps the best of detections that lie close together.
#pragma once

#include <vector>

#include "matching/engine.hpp"

namespace mbncc::bench {

/// Best score first; none within `distance` [px] of a better one.
std::vector<Found> without_neighbours(std::vector<Found> found, double distance);

}  // namespace mbncc::bench
