// What speaks for thin parts: preferences that add up along a line.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Mean preference (CV_32FC1, log-odds) over 13 px of the best line through each pixel, no pixel
/// counting more than 3; CV_32FC1. Lines that are no thinner than 9 px give none (-3): what is
/// wide needs no help.
cv::Mat line_evidence(const cv::Mat& preference);

}  // namespace mbncc
