// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes edits that move published poses from descriptive ones.
#pragma once

#include "mbncc/object_model.hpp"

namespace mbncc::library {

/// A copy that shares no pixels.
ObjectModel deep_copy(const ObjectModel& model);

/// True when views, references, scale, height, declared symmetry or grasp differ.
bool moves_poses(const ObjectModel& before, const ObjectModel& after);

}  // namespace mbncc::library
