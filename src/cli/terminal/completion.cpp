// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terminal/completion.hpp"

namespace mbncc::cli {
namespace {

bool names_a_path(const std::string& value) {
  return value.find(".png") != std::string::npos || value.find("DIR") != std::string::npos ||
         value.find("FILE") != std::string::npos || value.find(".csv") != std::string::npos;
}

/// "a|b|c" are choices.
std::string choices_of(std::string value) {
  if (value.find('|') == std::string::npos) return "";
  for (auto& c : value)
    if (c == '|') c = ' ';
  return value;
}

std::string names_of(const std::vector<Command>& commands) {
  std::string names;
  for (const auto& command : commands) names += command.name + " ";
  return names + "help";
}

// Values of --name are the files of the folder given by --library, or of the nodelets' folder.
constexpr const char* kFunction = R"sh(_mbncc() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} library=$HOME/.ros/mbncc_library i
  for ((i = 1; i < COMP_CWORD; i++)); do
    [ "${COMP_WORDS[i]}" = --library ] && library=${COMP_WORDS[i+1]/#\~/$HOME}
  done
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ] || [ "$before" = help ]; then
    COMPREPLY=($(compgen -W "$(_mbncc_words commands)" -- "$word"))
    return
  fi
  if [ "$before" = --name ]; then
    COMPREPLY=($(compgen -W "$(cd "$library" 2>/dev/null && for f in *.png; do echo "${f%.png}"; done)" -- "$word"))
    return
  fi
  local values=
  [ "${before#-}" != "$before" ] && values=$(_mbncc_words "${COMP_WORDS[1]} $before")
  if [ "$values" = ANY ]; then
    return
  elif [ -n "$values" ] && [ "$values" != FILE ]; then
    COMPREPLY=($(compgen -W "$values" -- "$word"))
  elif [ -z "$values" ] && [ "${word#-}" != "$word" ]; then
    COMPREPLY=($(compgen -W "$(_mbncc_words "${COMP_WORDS[1]}")" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _mbncc mbncc
)sh";

void print_words(std::ostream& out, const std::vector<Command>& commands) {
  out << "_mbncc_words() {\n  case \"$1\" in\n    commands) echo \"" << names_of(commands)
      << "\" ;;\n";
  for (const auto& command : commands) {
    std::string options = "--help";
    for (const auto& option : command.options) {
      options += " " + option.name;
      if (option.value.empty()) continue;
      const std::string choices = choices_of(option.value);
      out << "    \"" << command.name << ' ' << option.name << "\") echo \""
          << (names_a_path(option.value) ? "FILE"
              : choices.empty()          ? "ANY"
                                         : choices)
          << "\" ;;\n";
    }
    out << "    " << command.name << ") echo \"" << options << "\" ;;\n";
  }
  out << "  esac\n}\n";
}

}  // namespace

void print_completion(std::ostream& out, const std::string& shell,
                      const std::vector<Command>& commands) {
  if (shell != "bash" && shell != "zsh")
    throw UsageError("completion is for bash or zsh, not '" + shell + "'");
  out << "# Completion of mbncc. Now: source <(mbncc completion " << shell
      << "); permanently: that line in ~/." << shell << "rc\n";
  if (shell == "zsh") out << "autoload -U +X bashcompinit && bashcompinit\n";
  print_words(out, commands);
  out << kFunction;
}

}  // namespace mbncc::cli
