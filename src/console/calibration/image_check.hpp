// SPDX-License-Identifier: BSD-3-Clause
// Checks whether the camera's image is sharp and well exposed.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::console {

class ImageCheck {
 public:
  /// `image`: CV_8UC3.
  void take(const cv::Mat& image);

  /// Sharpness [0..1] relative to the sharpest image since the start; 0 before the first image.
  double sharpness() const { return best_ > 0 ? now_ / best_ : 0; }
  /// [0..1] fraction of overexposed pixels.
  double burnt() const { return burnt_; }
  /// [0..1] mean brightness.
  double brightness() const { return brightness_; }
  /// Two instructions for focus and exposure.
  std::string advice() const;

 private:
  double best_ = 0, now_ = 0, burnt_ = 0, brightness_ = 0;
};

}  // namespace mbncc::console
