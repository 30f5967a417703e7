// SPDX-License-Identifier: BSD-3-Clause
// Minimum cut on the pixel grid.
#pragma once

#include <opencv2/core.hpp>

#include "learning/segmentation/smoothness.hpp"

namespace mbncc::segmentation {

/// The map (0/255) with the least energy: sum of -unary over the object's pixels plus the weights
/// across its outline. `unary` is CV_32FC1, positive where a pixel prefers to be object.
cv::Mat minimum_cut(const cv::Mat& unary, const Smoothness& smoothness);

/// Minimum cut at half resolution, enlarged to the size of `unary`; `half` is
/// half_resolution(smoothness).
cv::Mat coarse_cut(const cv::Mat& unary, const Smoothness& half);

/// coarse_cut(unary + tilt, half), computed faster from `coarse`, the cut without tilt, because the
/// map only grows with the tilt.
cv::Mat tilted_coarse_cut(const cv::Mat& coarse, const cv::Mat& unary, float tilt,
                          const Smoothness& half);

/// Refines `map`, a coarse cut, near its outline and where single pixels disagree with it. This
/// nearly always finds the minimum, in a fraction of the time.
void refine_cut(const cv::Mat& unary, const Smoothness& smoothness, cv::Mat& map);

}  // namespace mbncc::segmentation
