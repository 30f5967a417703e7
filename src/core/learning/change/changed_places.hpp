// SPDX-License-Identifier: BSD-3-Clause
// Boxes around the groups of changed pixels.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/learning/change.hpp"

namespace mbncc::change {

/// Bounding box, with a margin (a wide one where the survey is noisy), of the groups of changed
/// pixels inside `within` that are at least `least_part` of the largest one; empty when nothing
/// changed there.
cv::Rect changed_region(const ChangeSurvey& survey, const cv::Rect& within, double least_part);

/// Bounding boxes, with the same margin, of all groups of pixels whose weight (CV_32FC1) is above
/// 0, the heaviest group first.
std::vector<cv::Rect> changed_places(const cv::Mat& weights, bool noisy);

}  // namespace mbncc::change
