// How far an operator's stroke speaks for the pixels around it.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Log-odds (CV_32FC1, >= 0) that a pixel of `picture` (CV_32FC3) belongs to what was painted
/// (CV_8UC1, 255 there): they fade along the shortest path from the stroke, faster across edges.
cv::Mat stroke_voice(const cv::Mat& picture, const cv::Mat& painted);

}  // namespace mbncc
