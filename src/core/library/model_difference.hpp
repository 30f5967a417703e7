// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes edits that change published poses from descriptive ones.
#pragma once

#include "mbncc/object_model.hpp"

namespace mbncc::library {

/// A copy that does not share pixels.
ObjectModel deep_copy(const ObjectModel& model);

/// True if views, references, scale, height, declared symmetry or grasp differ.
bool moves_poses(const ObjectModel& before, const ObjectModel& after);

}  // namespace mbncc::library
