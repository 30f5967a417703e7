// SPDX-License-Identifier: BSD-3-Clause
// Paths in the user's home folder.
#pragma once

#include <string>

namespace mbncc {

/// The path with a leading "~" or "~/" replaced by the home folder. Throws FileError if it begins
/// with one and HOME is not set, so that no folder named "~" is made.
std::string expand_home(const std::string& path);

}  // namespace mbncc
