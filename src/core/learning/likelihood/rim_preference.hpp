// SPDX-License-Identifier: BSD-3-Clause
// Which side of the outline a pixel near it belongs to, by the colours close by on either side
// (localized region-based contours, Lankton and Tannenbaum 2008).
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Log-odds of object against background, CV_32FC1 of the images' size.
struct RimPreference {
  cv::Mat log_odds;
  cv::Mat told;  ///< CV_8UC1, 255 where both sides have colours close by and log_odds counts
};

/// For the pixels within two pixels of the outline of `map` (CV_8UC1). A pixel there may show a
/// mixture of both sides; the nearer one has it. `platform` is what the image would show without
/// the object, both CV_32FC3; `sigma` [grey levels] the noise of their difference. Where the sides
/// look alike, or the pixel looks like neither, nothing is told.
RimPreference rim_preference(const cv::Mat& before, const cv::Mat& platform, const cv::Mat& map,
                             float sigma);

}  // namespace mbncc
