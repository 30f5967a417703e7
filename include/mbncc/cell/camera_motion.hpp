// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes a moved camera from objects moved in front of it, so that the message to the
// operator does not blame an arm.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Whether nearly all that can be followed from one image to the other has been displaced.
/// CV_8UC3, of one size. Where there is too little texture to follow: false.
bool camera_moved(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc
