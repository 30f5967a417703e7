// SPDX-License-Identifier: BSD-3-Clause
// Shell completion, generated from the commands' own descriptions.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cli/command.hpp"

namespace mbncc::cli {

/// Prints a self-contained script for `shell`, "bash" or "zsh". Throws UsageError for any other
/// shell.
void print_completion(std::ostream& out, const std::string& shell,
                      const std::vector<Command>& commands);

}  // namespace mbncc::cli
