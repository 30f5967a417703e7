// SPDX-License-Identifier: BSD-3-Clause
// Writes the pictures of a lesson's steps into a folder.
#pragma once

#include <string>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {

class StageWriter {
 public:
  /// Creates the folder; "" writes nothing.
  explicit StageWriter(std::string folder);

  /// Valid as long as this writer.
  StageObserver observer();

 private:
  std::string folder_;
  int count_ = 0;
};

}  // namespace mbncc::cli
