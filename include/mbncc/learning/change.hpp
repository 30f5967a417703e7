// SPDX-License-Identifier: BSD-3-Clause
// Coarse survey of the change between two images of a still camera: where to analyse it, and
// whether the images can be compared.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

struct ChangeSurvey {
  cv::Mat changed;        ///< CV_8UC1 of the images' size, 255 where they differ beyond noise
  double fraction = 0;    ///< [0..1] changed part of the image
  double displaced = 0;   ///< [0..1] part of the textured area whose texture was displaced
  double exposure = 1;    ///< exposure ratio of the images, >= 1
  double unevenness = 1;  ///< largest over smallest exposure ratio of the quarters, >= 1
  bool noisy = false;     ///< noise may hide much of the change
  cv::Point2d shift;      ///< [px] shift of the camera, accurate to about a pixel
};

/// Compares two CV_8UC3 images of one size at about 320 pixels width. Exposure per channel and
/// camera shift are compensated before the comparison.
ChangeSurvey survey_change(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc
