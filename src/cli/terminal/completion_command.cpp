// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/terminal/completion.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  if (arguments.operands().size() != 1)
    throw UsageError("completion is for one shell; give bash or zsh");
  print_completion(std::cout, arguments.operands().front(), all_commands());
  return kDone;
}

}  // namespace

Command completion_command() {
  return {"completion",
          "print a script that completes commands, options and names in bash or zsh",
          {},
          "bash|zsh",
          "Now: source <(mbncc completion bash). Permanently: add that line to ~/.bashrc, with zsh "
          "to\n ~/.zshrc.\n",
          run};
}

}  // namespace mbncc::cli
