// SPDX-License-Identifier: BSD-3-Clause
#include <iomanip>
#include <iostream>

#include "cli/command.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

void print_plain(const SettingsSection& section) {
  std::cout << "\n# " << section.title << '\n';
  for (const auto& row : section.rows) {
    const auto& info = row.info;
    std::cout << std::left << std::setw(18) << info.name << ' ' << std::setw(8)
              << (row.value.empty() ? "\"\"" : row.value) << ' ' << std::setw(9)
              << (info.unit.empty() ? row.type : info.unit) << ' ' << std::setw(22)
              << info.allowed.to_string() << ' ' << info.meaning << '\n';
  }
}

void print_markdown(const SettingsSection& section) {
  std::cout << "\n"
            << section.title << "\n\n| name | default | unit | range | meaning |\n"
            << "|---|---|---|---|---|\n";
  for (const auto& row : section.rows) {
    std::string range = row.info.allowed.to_string();
    for (auto bar = range.find(" | "); bar != std::string::npos; bar = range.find(" | "))
      range.replace(bar, 3, ", ");
    std::cout << "| " << row.info.name << " | " << (row.value.empty() ? "\"\"" : row.value) << " | "
              << row.info.unit << " | " << range << " | " << row.info.meaning << " |\n";
  }
}

ExitCode run(const Arguments& arguments) {
  Settings settings = settings_from(arguments);
  const bool markdown = arguments.has("--markdown");
  if (!markdown) std::cout << "name, value, unit or type, range, meaning\n";
  for (const auto& section : sections_of(settings))
    markdown ? print_markdown(section) : print_plain(section);
  return kDone;
}

}  // namespace

Command params_command() {
  return {"params",
          "list every parameter of the tool and the nodelets",
          {{"--markdown", "", "print Markdown tables"}},
          "",
          "Prints the defaults, changed by --config and --set.\n",
          run};
}

}  // namespace mbncc::cli
