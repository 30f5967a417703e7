// SPDX-License-Identifier: BSD-3-Clause
#include "cli/help.hpp"

#include <algorithm>
#include <iomanip>

namespace mbncc::cli {
namespace {

constexpr std::size_t kColumn = 25;  // [characters] width of the column for an option and its value

std::string written(const Option& option) {
  return option.value.empty() ? option.name : option.name + " " + option.value;
}

}  // namespace

void print_help(std::ostream& out, const std::vector<Command>& commands) {
  out << "mbncc: teach, find and manage objects under a camera\n\n"
         "usage: mbncc COMMAND [OPTIONS]\n\n";
  std::size_t width = 0;
  for (const auto& command : commands) width = std::max(width, command.name.size());
  for (const auto& command : commands)
    out << "  " << std::left << std::setw(static_cast<int>(width) + 2) << command.name
        << command.summary << '\n';
  out << "\n'mbncc COMMAND --help' explains a command, 'mbncc --version' prints the version.\n"
         "Exit codes: 0 done, 1 refused or failed (reason on stderr), 2 wrong usage.\n";
}

void print_help(std::ostream& out, const Command& command) {
  out << "mbncc " << command.name << ": " << command.summary << "\n\nusage: mbncc " << command.name;
  for (const auto& option : command.options) {
    if (option.required) out << ' ' << written(option);
  }
  out << " [OPTIONS]" << (command.operand.empty() ? "" : " " + command.operand + "...") << "\n\n";
  for (const auto& option : command.options) {
    const std::string name = written(option);
    out << "  " << std::left << std::setw(static_cast<int>(kColumn)) << name
        << (name.size() > kColumn ? "\n" + std::string(kColumn + 3, ' ') : " ") << option.meaning
        << (option.repeatable ? " (repeatable)" : "") << '\n';
  }
  if (!command.remarks.empty()) out << '\n' << command.remarks;
}

}  // namespace mbncc::cli
