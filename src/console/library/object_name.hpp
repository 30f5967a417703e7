// SPDX-License-Identifier: BSD-3-Clause
// Converts typed names to valid ones.
#pragma once

#include <string>
#include <vector>

namespace mbncc::console {

struct TypedName {
  std::string name;       ///< accepted by the library, or ""
  std::string complaint;  ///< what was changed and why; "": unchanged
};

/// Spaces and dashes become underscores; other invalid characters are removed. UTF-8.
TypedName usable_name(const std::string& typed);

/// "bracket_2", or the next number that is not in `taken`.
std::string free_name(const std::string& name, const std::vector<std::string>& taken);

}  // namespace mbncc::console
