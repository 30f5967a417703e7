// SPDX-License-Identifier: BSD-3-Clause
// Tells a camera that sends the same picture again and again from a live one, whose noise differs.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

class FrozenPicture {
 public:
  /// Takes the next picture; true from the fifth exactly equal one in a row on. Keeps the picture,
  /// so it must not be written to afterwards.
  bool update(const cv::Mat& picture);

  void reset();

 private:
  cv::Mat last_;
  int equal_ = 0;  // in a row, up to last_
};

}  // namespace mbncc
