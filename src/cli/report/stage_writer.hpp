// SPDX-License-Identifier: BSD-3-Clause
// Writes the images of a lesson's stages into a folder.
#pragma once

#include <string>
#include <vector>

#include "cli/terminal/progress.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {

class StageWriter {
 public:
  /// Creates the folder; with "" nothing is written. `inputs` are not replaced.
  StageWriter(std::string folder, std::vector<std::string> inputs);

  /// Also shows the stages on `progress`. The observer is valid as long as this object and
  /// `progress`; it is empty if nothing would be written or shown.
  StageObserver observer(Progress& progress);

  /// Reports on stderr what was written.
  void tell() const;

 private:
  std::string folder_;
  std::vector<std::string> inputs_;
  int count_ = 0;
};

}  // namespace mbncc::cli
