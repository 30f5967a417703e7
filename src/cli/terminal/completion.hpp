// SPDX-License-Identifier: BSD-3-Clause
// Shell completion, made from the commands' own descriptions.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cli/command.hpp"

namespace mbncc::cli {

/// A script for `shell`, "bash" or "zsh", without other dependencies. Throws
/// UsageError for another one.
void print_completion(std::ostream& out, const std::string& shell,
                      const std::vector<Command>& commands);

}  // namespace mbncc::cli
