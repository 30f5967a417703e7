// SPDX-License-Identifier: BSD-3-Clause
// White balance: estimates a colour cast of the light from the detected objects.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "matching/decision/detection.hpp"
#include "matching/evidence/local_cast.hpp"
#include "matching/prepared/comparison.hpp"

namespace mbncc::search {

/// Estimate from the best detection of each object compared in colour; `found` has one entry per
/// comparison. None if there is no cast, or fewer than two likely detections agree.
std::optional<evidence::ColourCast> colour_cast(
    const std::vector<prepared::Comparison>& compared,
    const std::vector<std::vector<decision::Detection>>& found);

/// `image`, CV_8UC3 (bgr), without the cast.
cv::Mat without_cast(const cv::Mat& image, const evidence::ColourCast& cast);

}  // namespace mbncc::search
