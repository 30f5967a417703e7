// SPDX-License-Identifier: BSD-3-Clause
// Compares two images of one camera coarsely.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

enum class SceneChange {
  kNone,
  kInside,   ///< something came, went or moved inside the image
  kAtBorder  ///< the change reaches the image's edge: an arm in view, or an object half outside
};

/// Coarse difference of two images of one camera.
struct SceneDifference {
  SceneChange change = SceneChange::kNone;
  cv::Mat changed;      ///< CV_8UC1 of the images' size, 255 where they differ beyond noise
  double fraction = 0;  ///< [0..1] changed part of the image
  double exposure = 1;  ///< exposure ratio of the images, >= 1; compensated before the comparison
};

/// Compares two images of one camera (CV_8UC3, same size) coarsely. It decides when to analyse
/// the change, not where the object is.
SceneDifference scene_difference(const cv::Mat& before, const cv::Mat& after);

/// Only the `change` of scene_difference().
SceneChange scene_change(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc
