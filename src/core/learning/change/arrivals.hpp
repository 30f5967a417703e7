// SPDX-License-Identifier: BSD-3-Clause
// Finds objects that were put down inside a region.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"

namespace mbncc::change {

/// 255 on the connected patches of `changed` (CV_8UC1) that are certain arrivals and score clearly
/// lower than the best other patch. Images are CV_32FC3, aligned; `platform` is the colour
/// mixture of the ring. An empty mixture gives no arrivals.
cv::Mat find_arrivals(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const ColourMixture& platform);

}  // namespace mbncc::change
