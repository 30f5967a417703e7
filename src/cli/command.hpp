// SPDX-License-Identifier: BSD-3-Clause
// The parts of a command of the tool. Each command has its own file, <name>_command.cpp.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"

namespace mbncc::cli {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2 };

struct Command {
  std::string name;
  std::string summary;  ///< one line
  std::vector<Option> options;
  std::string operand;  ///< "IMAGE"; "": none
  std::string remarks;  ///< printed below the options by --help
  ExitCode (*run)(const Arguments& arguments);
};

Command learn_command();
Command find_command();
Command explain_command();
Command replay_command();
Command evaluate_command();
Command completion_command();
Command map_command();
Command list_command();
Command show_command();
Command edit_command();
Command forget_command();
Command restore_command();
Command check_command();
Command params_command();
Command simulate_command();

/// All commands with their options.
std::vector<Command> all_commands();

/// Options that several commands share.
Option library_option();
Option name_option();
Option json_option();

}  // namespace mbncc::cli
