// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes images of the user from damaged objects: a library folder may contain both.
#pragma once

#include <string>

namespace mbncc::library {

/// True for an intact PNG file, including all checksums, without an object's text chunk. False for
/// anything else: an object, intact or damaged, another format, or no regular file.
bool is_other_image(const std::string& path);

}  // namespace mbncc::library
