// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes a moved camera from objects that moved in front of it, so that the operator is told
// the actual cause.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Whether nearly all textured parts of the scene were displaced between the images (CV_8UC3, same
/// size). False if there is too little texture to tell.
bool camera_moved(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc
