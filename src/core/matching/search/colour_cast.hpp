// SPDX-License-Identifier: BSD-3-Clause
// Light of another colour than in the lessons, told by the objects that are found in spite of it.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "matching/decision/detection.hpp"
#include "matching/evidence/local_cast.hpp"

namespace mbncc {

/// What the best detection of each object tells, `found` being one object's each, best first; none
/// when the light is as it was, or when fewer than two likely ones agree.
std::optional<ColourCast> colour_cast(const std::vector<std::vector<Detection>>& found,
                                      const ScenePicture& scene);

/// `picture`, CV_8UC3 (bgr), as without the cast.
cv::Mat without_cast(const cv::Mat& picture, const ColourCast& cast);

}  // namespace mbncc
