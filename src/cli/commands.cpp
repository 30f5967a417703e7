// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {

std::vector<Command> all_commands() {
  std::vector<Command> commands = {
      learn_command(),   find_command(),  explain_command(), replay_command(),  evaluate_command(),
      map_command(),     list_command(),  show_command(),    edit_command(),    forget_command(),
      restore_command(), check_command(), params_command(),  simulate_command()};
  for (auto& command : commands)
    for (const auto& option : settings_options()) command.options.push_back(option);
  commands.push_back(completion_command());
  return commands;
}

}  // namespace mbncc::cli
