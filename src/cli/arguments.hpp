// SPDX-License-Identifier: BSD-3-Clause
// Command lines: the options of a command and the given values.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace mbncc::cli {

/// Wrong usage: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Option {
  std::string name;   ///< "--roi"
  std::string value;  ///< "x,y,w,h"; "" for a flag
  std::string meaning;
  bool required = false;
  bool repeatable = false;
};

/// The values given for a command's options, and its operands.
class Arguments {
 public:
  /// Throws UsageError for unknown, repeated, incomplete or missing options. If `operand` is empty,
  /// no operands are accepted, otherwise at least one is needed.
  Arguments(const std::vector<Option>& options, const std::string& operand,
            const std::vector<std::string>& words);

  bool has(const std::string& option) const { return values_.count(option) != 0; }

  /// Last value of the option, or `otherwise` if it is not given.
  std::string get(const std::string& option, const std::string& otherwise = "") const;

  /// All values of the option, in order.
  std::vector<std::string> all(const std::string& option) const;

  const std::vector<std::string>& operands() const { return operands_; }

  /// Throws UsageError if more than one of `options` is given.
  void at_most_one_of(const std::vector<std::string>& options) const;

 private:
  using Word = std::vector<std::string>::const_iterator;

  Word take_option(const std::vector<Option>& options, Word word, Word end);
  void check_complete(const std::vector<Option>& options, const std::string& operand) const;

  std::map<std::string, std::vector<std::string>> values_;
  std::vector<std::string> operands_;
};

}  // namespace mbncc::cli
