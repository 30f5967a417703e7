// SPDX-License-Identifier: BSD-3-Clause
// mbncc: teaches, finds and manages objects without a ROS graph.
#include <algorithm>
#include <exception>
#include <iostream>
#include <opencv2/core/utility.hpp>

#include "cli/command.hpp"
#include "cli/help.hpp"
#include "cli/settings.hpp"
#include "mbncc/did_you_mean.hpp"
#include "mbncc/error.hpp"

namespace mbncc::cli {
namespace {

const Command& command_called(const std::string& name, const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const auto& command : commands) {
    if (command.name == name) return command;
    names.push_back(command.name);
  }
  throw UsageError("unknown command '" + name + "'" + did_you_mean(name, names));
}

bool asks_for_help(const std::vector<std::string>& words) {
  for (const auto& word : words) {
    if (word == "--") return false;
    if (word == "--help" || word == "-h") return true;
  }
  return false;
}

ExitCode run(const std::vector<std::string>& words) {
  const auto commands = all_commands();
  if (words.empty()) throw UsageError("no command is given");
  if (words[0] == "help" && words.size() > 1) {
    print_help(std::cout, command_called(words[1], commands));
    return kDone;
  }
  if (words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
    print_help(std::cout, commands);
    return kDone;
  }
  if (words[0] == "--version") {
    std::cout << "mbncc " << MBNCC_VERSION << '\n';
    return kDone;
  }
  const Command& command = command_called(words[0], commands);
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (asks_for_help(rest)) {
    print_help(std::cout, command);
    return kDone;
  }
  return command.run(Arguments(command.options, command.operand, rest));
}

ExitCode wrong_usage(const std::string& sentence, const std::vector<std::string>& words) {
  const auto commands = all_commands();
  const bool known = !words.empty() &&
                     std::any_of(commands.begin(), commands.end(),
                                 [&](const Command& command) { return command.name == words[0]; });
  std::cerr << "mbncc: " << sentence << "\nTry 'mbncc " << (known ? words[0] + " " : "")
            << "--help'.\n";
  return kWrongUsage;
}

ExitCode run_guarded(const std::vector<std::string>& words) {
  try {
    const ExitCode code = run(words);
    std::cout.flush();
    if (std::cout) return code;
    std::cerr << "mbncc: the output could not be written; check the disk's space\n";
  } catch (const UsageError& error) {
    return wrong_usage(error.what(), words);
  } catch (const ConfigError& error) {
    return wrong_usage(error.what(), words);
  } catch (const std::exception& error) {
    std::cerr << "mbncc: " << error.what() << '\n';
  }
  return kFailed;
}

}  // namespace
}  // namespace mbncc::cli

int main(int count, char** words) {
  cv::setNumThreads(1);  // starting OpenCV's threads would take longer than they save
  return mbncc::cli::run_guarded({words + 1, words + count});
}
