// SPDX-License-Identifier: BSD-3-Clause
// Detects a gripper or an arm that reaches into the region in the image after.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"
#include "learning/likelihood/noise_model.hpp"

namespace mbncc::segmentation {

/// The connected patches of `changed` (CV_8UC1) that reach its border, so they entered from
/// outside.
cv::Mat reaching_border(const cv::Mat& changed);

/// CV_8UC1, 255 on what covers the platform or the vacated place in `after` and is connected to
/// `entry` (CV_8UC1), the changed pixels outside the region. Patches of `entry` where something
/// left are ignored. `before` and `after` are CV_32FC3, aligned, `changed` is CV_8UC1; `platform`
/// is the colour mixture of the ring.
cv::Mat find_intruders(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                       const cv::Mat& entry, const change::ColourMixture& platform,
                       const likelihood::NoiseModel& noise);

}  // namespace mbncc::segmentation
