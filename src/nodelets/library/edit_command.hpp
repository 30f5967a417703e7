// SPDX-License-Identifier: BSD-3-Clause
// The commands of the edit_object service, carried out on a library.
#pragma once

#include <mbncc_vision/EditObject.h>

#include "mbncc/library/object_library.hpp"

namespace mbncc::nodelets {

/// Carries `request` out and returns the object as it now is (DELETE: as it was). Throws
/// std::invalid_argument with a sentence when the request is wrong, FileError when the library
/// cannot be written; then nothing has changed.
ObjectModel edit_object(ObjectLibrary& library, const mbncc_vision::EditObject::Request& request);

}  // namespace mbncc::nodelets
