// SPDX-License-Identifier: BSD-3-Clause
// Edits of an object's list of views.
#pragma once

#include <cstddef>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// Removes view `number`, counted from 1; object frame and other views are unchanged. Throws
/// std::invalid_argument if there is no such view, or if it is the only one.
void remove_view(ObjectModel& model, std::size_t number);

}  // namespace mbncc
