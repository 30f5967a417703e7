// SPDX-License-Identifier: BSD-3-Clause
// Error reporting of the core: misuse throws std::invalid_argument, a file that cannot be read or
// written throws FileError, and expected failures of a lesson are LearnError values.
#pragma once

#include <stdexcept>
#include <string>

namespace mbncc {

/// A file or folder that could not be read, written or parsed; `what()` contains path and reason.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& reason)
      : std::runtime_error(path + ": " + reason), path_(path), reason_(reason) {}

  const std::string& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

/// A parameter that is unknown, of the wrong type or out of range; `what()` names the key, the
/// value and the allowed values.
class ConfigError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Outcome of a lesson. The numbers are those of action/LearnObject.action.
enum class LearnError : int {
  kSuccess = 0,
  kNoImage = -1,
  kRegionInvalid = -2,
  kNoChange = -3,
  kChangeTooLarge = -4,
  kNotStill = -5,
  kSegmentationEmpty = -6,
  kSegmentationFull = -7,
  kTouchesBorder = -8,
  kTooSmall = -9,
  kLowTexture = -10,
  kNotDistinct = -11,
  kAlreadyKnown = -12,
  kNameInvalid = -13,
  kNameTaken = -14,
  kStorage = -15,
  kRejectedByOperator = -16,
  kCancelled = -17,
  kTimeout = -18,
  kEncoding = -19,
  kBusy = -20,
  kNameUnknown = -21,
  kImageMismatch = -22,
  kQualityBad = -23,
  kInternal = -99,
};

/// Name as spelled in action/LearnObject.action, e.g. "NO_CHANGE".
const char* to_string(LearnError error);

/// One sentence for the operator that says what happened.
const char* message_of(LearnError error);

/// One sentence for the operator that says what to do about it.
const char* hint_of(LearnError error);

}  // namespace mbncc
