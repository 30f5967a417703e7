// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terminal/completion.hpp"

namespace mbncc::cli {
namespace {

bool names_a_path(const std::string& value) {
  return value.find(".png") != std::string::npos || value.find("DIR") != std::string::npos ||
         value.find("FILE") != std::string::npos || value.find(".csv") != std::string::npos;
}

/// Values of the form "a|b|c" are choices.
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

// bash splits --option=value at the equals sign, zsh does not. The values of --name are the files
// in the folder given by --library, or in the nodelets' folder.
constexpr const char* kFunction = R"sh(_mbncc() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} library=$HOME/.ros/mbncc_library start= i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "${COMP_WORDS[i]}" in
      --library) library=${COMP_WORDS[i+1]}; [ "$library" = = ] && library=${COMP_WORDS[i+2]} ;;
      --library=*) library=${COMP_WORDS[i]#--library=} ;;
    esac
  done
  library=${library/#\~/$HOME}
  if [ "$word" = = ]; then
    word=
  elif [ "$before" = = ]; then
    before=${COMP_WORDS[COMP_CWORD-2]}
  elif [ "${word#--*=}" != "$word" ]; then
    start=${word%%=*}= before=${word%%=*} word=${word#--*=}
  fi
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ] || [ "$before" = help ]; then
    COMPREPLY=($(compgen -P "$start" -W "$(_mbncc_words commands)" -- "$word"))
    return
  fi
  if [ "$before" = --name ]; then
    COMPREPLY=($(compgen -P "$start" -W "$(cd "$library" 2>/dev/null && for f in *.png; do echo "${f%.png}"; done)" -- "$word"))
    return
  fi
  local values= operands=$(_mbncc_words "${COMP_WORDS[1]} operand")
  [ "${before#-}" != "$before" ] && values=$(_mbncc_words "${COMP_WORDS[1]} $before")
  if [ "$values" = ANY ]; then
    return
  elif [ -n "$values" ] && [ "$values" != FILE ]; then
    COMPREPLY=($(compgen -P "$start" -W "$values" -- "$word"))
  elif [ -z "$values" ] && [ "${word#-}" != "$word" ]; then
    COMPREPLY=($(compgen -P "$start" -W "$(_mbncc_words "${COMP_WORDS[1]}")" -- "$word"))
  elif [ -z "$values" ] && [ -n "$operands" ]; then
    COMPREPLY=($(compgen -W "$operands" -- "$word"))
  else
    COMPREPLY=($(compgen -P "$start" -f -- "$word"))
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
    if (!names_a_path(command.operand) && !choices_of(command.operand).empty())
      out << "    \"" << command.name << " operand\") echo \"" << choices_of(command.operand)
          << "\" ;;\n";
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
