// SPDX-License-Identifier: BSD-3-Clause
// Detects what reaches into the region in the image after: the gripper, an arm.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"
#include "learning/likelihood/noise_model.hpp"

namespace mbncc::segmentation {

/// The connected patches of `changed` (CV_8UC1) that reach its border, so they entered from
/// outside.
cv::Mat reaching_border(const cv::Mat& changed);

/// What covers the platform or the vacated place in `after` and is connected to `entry`, changed
/// pixels outside the region, CV_8UC1. Patches of it where something left give none. `before` and
/// `after` are CV_32FC3, aligned, `changed` is CV_8UC1; `platform` is the colour mixture of the
/// ring.
cv::Mat find_intruders(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                       const cv::Mat& entry, const change::ColourMixture& platform,
                       const likelihood::NoiseModel& noise);

}  // namespace mbncc::segmentation
