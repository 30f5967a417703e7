// SPDX-License-Identifier: BSD-3-Clause
// What happened to texture between two pictures, which light and exposure leave alone in other ways
// than a moved camera.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

struct TextureChange {
  /// Part of the textured squares [0..1] that show something else in the other picture. Light and
  /// exposure leave the correlation of small squares alone; a moved camera does not. It displaces
  /// the texture of both pictures, so the smaller of both parts counts: of a scene that many things
  /// left, the rest stays.
  double displaced = 0;
  /// Median factor from the contrast of a square after to that before; 1 where too little is
  /// textured well enough, or all of that is near white. Contrast knows a gain, but no offset,
  /// which in dark pictures passes for one.
  double contrast = 1;
};

/// Of grey pictures, CV_32FC1 and of one size; 255 is white in `before`, and `white` in `after`,
/// which has been made as bright.
TextureChange texture_change(const cv::Mat& before, const cv::Mat& after, double white);

}  // namespace mbncc
