// SPDX-License-Identifier: BSD-3-Clause
// Names as operators type them.
#pragma once

#include <string>
#include <vector>

namespace mbncc::console {

struct TypedName {
  std::string name;       ///< that the library takes, or ""
  std::string complaint;  ///< what was changed and why; "": nothing
};

/// Spaces and dashes become underscores; whatever else no name may hold is left out. UTF-8.
TypedName usable_name(const std::string& typed);

/// "bracket_2", or the next number that none of `taken` has.
std::string free_name(const std::string& name, const std::vector<std::string>& taken);

}  // namespace mbncc::console
