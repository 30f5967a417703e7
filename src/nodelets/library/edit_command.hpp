// SPDX-License-Identifier: BSD-3-Clause
// Carries out the commands of the edit_object service on a library.
#pragma once

#include <mbncc_vision/EditObject.h>

#include "mbncc/library/object_library.hpp"

namespace mbncc::nodelets {

/// Carries out `request` and returns the changed object (DELETE: the deleted one). Throws
/// std::invalid_argument with a message if the request is wrong, FileError if the library cannot be
/// written; nothing is changed in either case.
ObjectModel edit_object(ObjectLibrary& library, const mbncc_vision::EditObject::Request& request);

}  // namespace mbncc::nodelets
