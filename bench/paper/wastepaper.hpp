// SPDX-License-Identifier: BSD-3-Clause
// A crumpled sheet of paper beside the object, as in Figs. 14c and 16 of the paper.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace mbncc::bench {

/// Draws the sheet, `diameter` [px] across, into `image` (CV_8UC3). The same seed gives the same
/// drawing.
void draw_wastepaper(cv::Mat& image, cv::Point2d centre, double diameter, std::uint64_t seed);

}  // namespace mbncc::bench
