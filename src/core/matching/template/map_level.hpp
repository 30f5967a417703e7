// SPDX-License-Identifier: BSD-3-Clause
// A template and its map at one level of the pyramid.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::templates {

struct MapLevel {
  cv::Mat values;    ///< CV_32FC1 mean grey value of the map pixels within each pixel
  cv::Mat coverage;  ///< CV_32FC1 [0..1] part of each pixel that the map covers
};

/// `grey` must be CV_8UC1, and `map` binary and of the same size; otherwise throws
/// std::invalid_argument.
MapLevel map_level(const cv::Mat& grey, const cv::Mat& map, int level);

}  // namespace mbncc::templates
