// SPDX-License-Identifier: BSD-3-Clause
// Finds the places that something left, in whole images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::change {

/// Evidence of a departure in whole images (CV_8UC3) without a given region: CV_32FC1 of their
/// size, above 0 on the patches of `changed` (CV_8UC1) except arrivals. An arrival is not in the
/// image before, so a lesson on it would teach bare platform. Computed at about 320 pixels width.
cv::Mat departures(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed);

}  // namespace mbncc::change
