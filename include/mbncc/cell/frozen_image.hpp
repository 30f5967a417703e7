// SPDX-License-Identifier: BSD-3-Clause
// Detects a camera that repeats the same image; the noise of live images differs.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

class FrozenImage {
 public:
  /// Processes the next image; true from the fifth identical one in a row on. Keeps a reference
  /// to the image, so it must not be modified afterwards.
  bool update(const cv::Mat& image);

 private:
  cv::Mat last_;
  int equal_ = 0;  // identical images in a row, up to last_
};

}  // namespace mbncc
