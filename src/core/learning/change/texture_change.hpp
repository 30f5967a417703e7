// SPDX-License-Identifier: BSD-3-Clause
// Change of texture between two images, which distinguishes light and exposure from a moved
// camera.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::change {

struct TextureChange {
  /// Part of the textured squares [0..1] that do not correlate with the other image. Light and
  /// exposure keep the correlation of small squares; a moved camera does not. It displaces the
  /// texture of both images, so the smaller part is returned: in a scene that was cleared, the
  /// remaining texture is unchanged.
  double displaced = 0;
  /// Median ratio of a square's contrast before to its contrast after; 1 if too little is textured,
  /// or all textured squares are near white. Contrast depends on the gain but not on an offset,
  /// which in dark images resembles a gain.
  double contrast = 1;
};

/// Compares grey images (CV_32FC1, same size). `after` was scaled to the brightness of `before`;
/// white is 255 in `before` and `white` in `after`. Noise and faulty pixels count as no texture.
TextureChange texture_change(const cv::Mat& before, const cv::Mat& after, double white);

}  // namespace mbncc::change
