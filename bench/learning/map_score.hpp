// SPDX-License-Identifier: BSD-3-Clause
// Agreement of a map with the true one.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::bench {

struct MapScore {
  double iou = 0;         ///< [0..1] intersection over union
  double boundary_f = 0;  ///< [0..1] F1 of boundary pixels within 2 px of the other boundary
  double accuracy = 0;  ///< [..1] as in the paper: 1 - sum |map - standard| / area of the standard
};

/// Both are CV_8UC1 of the same size, 0 and 255. An empty `map` scores 0 throughout.
MapScore score_map(const cv::Mat& map, const cv::Mat& standard, double boundary_tolerance = 2);

}  // namespace mbncc::bench
