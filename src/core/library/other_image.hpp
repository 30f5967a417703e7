// SPDX-License-Identifier: BSD-3-Clause
// Tells images of the user from damaged objects: a library folder may hold both.
#pragma once

#include <string>

namespace mbncc::library {

/// True for an intact PNG file, all checksums included, without an object's text chunk. Anything
/// else is false: an object, sound or damaged, another format, no regular file.
bool is_other_image(const std::string& path);

}  // namespace mbncc::library
