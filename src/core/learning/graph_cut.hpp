// Minimum cut on the pixel grid.
#pragma once

#include <opencv2/core.hpp>

#include "learning/smoothness.hpp"

namespace mbncc {

/// The map (0/255) with the least energy: sum of -unary over the object's pixels plus the weights
/// across its outline. `unary` is CV_32FC1, positive where a pixel prefers to be object.
cv::Mat minimum_cut(const cv::Mat& unary, const Smoothness& smoothness);

}  // namespace mbncc
