// SPDX-License-Identifier: BSD-3-Clause
// Energy of a cut whose outline follows the borders of 2 x 2 pixel blocks.
#pragma once

#include <opencv2/core.hpp>

#include "learning/segmentation/smoothness.hpp"

namespace mbncc::segmentation {

/// Sums of 2 x 2 blocks; an odd last row or column forms blocks of its own.
cv::Mat half_resolution(const cv::Mat& unary);

/// Weights between blocks: the sums of the weights of the pixel edges between them.
Smoothness half_resolution(const Smoothness& smoothness);

}  // namespace mbncc::segmentation
