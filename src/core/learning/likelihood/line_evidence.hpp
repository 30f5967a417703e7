// SPDX-License-Identifier: BSD-3-Clause
// Evidence for thin parts and narrow gaps: preferences averaged along lines.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// Evidence per pixel, CV_32FC1; -3 where there is none.
struct LineEvidence {
  cv::Mat parts;  ///< mean preference along the best line with platform on both sides
  cv::Mat gaps;  ///< mean preference for the platform along the best line with object on both sides
};

/// `preference` is CV_32FC1, log-odds of the object. Lines are 13 px long, and no pixel counts more
/// than 3. Structures 9 px or more wide are not lines.
LineEvidence line_evidence(const cv::Mat& preference);

}  // namespace mbncc::likelihood
