// SPDX-License-Identifier: BSD-3-Clause
// Edits of an object's list of views.
#pragma once

#include <cstddef>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// Takes the view `number`, counted from 1, away; object frame and other views stay as they are.
/// Throws std::invalid_argument when there is no such view, or no other.
void remove_view(ObjectModel& model, std::size_t number);

}  // namespace mbncc
