// SPDX-License-Identifier: BSD-3-Clause
// Assigns pixels near the outline to one side, by the local colours on either side
// (localized region-based contours, Lankton and Tannenbaum 2008).
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// Log-odds of object against background, CV_32FC1 of the images' size.
struct RimPreference {
  cv::Mat log_odds;
  cv::Mat valid;  ///< CV_8UC1, 255 where both sides have local colours and log_odds is valid
};

/// For the pixels within two pixels of the outline of `map` (CV_8UC1). A pixel there may be a
/// mixture of both sides; it is assigned to the more similar one. `platform` is the image without
/// the object, both CV_32FC3; `sigma` [grey levels] is the noise of their difference. If the sides
/// look alike, or the pixel resembles neither, log_odds is not valid.
RimPreference rim_preference(const cv::Mat& before, const cv::Mat& platform, const cv::Mat& map,
                             float sigma);

}  // namespace mbncc::likelihood
