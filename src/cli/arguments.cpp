// SPDX-License-Identifier: BSD-3-Clause
#include "cli/arguments.hpp"

#include <cctype>

#include "mbncc/did_you_mean.hpp"

namespace mbncc::cli {
namespace {

const Option& known_option(const std::vector<Option>& options, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& option : options) {
    if (option.name == name) return option;
    names.push_back(option.name);
  }
  throw UsageError("unknown option '" + name + "'" + did_you_mean(name, names));
}

/// Turns "bash|zsh" into "bash or zsh".
std::string in_words(std::string choices) {
  const auto bar = choices.find('|');
  return bar == std::string::npos ? choices : choices.replace(bar, 1, " or ");
}

bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || std::isdigit(static_cast<unsigned char>(word[1])) == 0);
}

}  // namespace

Arguments::Arguments(const std::vector<Option>& options, const std::string& operand,
                     const std::vector<std::string>& words) {
  bool only_operands = false;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (only_operands || !looks_like_option(*word))
      operands_.push_back(*word);
    else if (*word == "--")
      only_operands = true;
    else
      word = take_option(options, word, words.end());
  }
  check_complete(options, operand);
}

// Returns the last word that was consumed.
Arguments::Word Arguments::take_option(const std::vector<Option>& options, Word word, Word end) {
  const auto equals = word->find('=');
  const bool has_value = equals != std::string::npos;
  const Option& option = known_option(options, word->substr(0, equals));
  auto& values = values_[option.name];
  if (!values.empty() && !option.repeatable)
    throw UsageError(option.name + " is given twice; give it once");
  if (option.value.empty()) {
    if (has_value) throw UsageError(option.name + " takes no value");
    values.emplace_back();
    return word;
  }
  if (!has_value && (++word == end || looks_like_option(*word)))
    throw UsageError(option.name + " needs a value: " + option.name + " " + option.value);
  values.push_back(has_value ? word->substr(equals + 1) : *word);
  if (values.back().empty()) throw UsageError(option.name + " needs a value that is not empty");
  return word;
}

void Arguments::check_complete(const std::vector<Option>& options,
                               const std::string& operand) const {
  for (const auto& option : options)
    if (option.required && !has(option.name))
      throw UsageError(option.name + " " + option.value + " is missing");
  if (operand.empty() && !operands_.empty())
    throw UsageError("'" + operands_.front() + "' is not expected here");
  if (!operand.empty() && operands_.empty())
    throw UsageError("an argument is missing; give " + in_words(operand));
}

std::string Arguments::get(const std::string& option, const std::string& otherwise) const {
  const auto found = values_.find(option);
  return found == values_.end() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::all(const std::string& option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::vector<std::string>{} : found->second;
}

void Arguments::at_most_one_of(const std::vector<std::string>& options) const {
  std::string given;
  for (const auto& option : options) {
    if (!has(option)) continue;
    if (!given.empty())
      throw UsageError(given + " and " + option + " cannot be combined; give only one");
    given = option;
  }
}

}  // namespace mbncc::cli
