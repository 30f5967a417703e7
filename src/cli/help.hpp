// SPDX-License-Identifier: BSD-3-Clause
// Help texts, generated from the commands' own descriptions.
#pragma once

#include <ostream>
#include <vector>

#include "cli/command.hpp"

namespace mbncc::cli {

void print_help(std::ostream& out, const std::vector<Command>& commands);
void print_help(std::ostream& out, const Command& command);

}  // namespace mbncc::cli
