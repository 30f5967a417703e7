// SPDX-License-Identifier: BSD-3-Clause
// Keeps the best one of detections that lie close together.
#pragma once

#include <vector>

#include "matching/engine.hpp"

namespace mbncc::bench {

/// In descending order of score; none is within `distance` [px] of a better one.
std::vector<Found> without_neighbours(std::vector<Found> found, double distance);

}  // namespace mbncc::bench
