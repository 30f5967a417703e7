// SPDX-License-Identifier: BSD-3-Clause
// Detects a camera that repeats the same picture; in live pictures the noise differs.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

class FrozenPicture {
 public:
  /// Processes the next picture; true from the fifth identical one in a row on. Keeps a reference
  /// to the picture, so it must not be modified afterwards.
  bool update(const cv::Mat& picture);

  void reset();

 private:
  cv::Mat last_;
  int equal_ = 0;  // in a row, up to last_
};

}  // namespace mbncc
