// SPDX-License-Identifier: BSD-3-Clause
// Writes the images of a lesson's steps into a folder.
#pragma once

#include <string>

#include "cli/terminal/progress.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {

class StageWriter {
 public:
  /// Creates the folder; "" writes nothing.
  explicit StageWriter(std::string folder);

  /// Shows the steps on `progress` as well. Valid as long as both; empty if nobody would see them.
  StageObserver observer(Progress& progress);

  /// Says on stderr what was written.
  void tell() const;

 private:
  std::string folder_;
  int count_ = 0;
};

}  // namespace mbncc::cli
