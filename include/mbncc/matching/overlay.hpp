// SPDX-License-Identifier: BSD-3-Clause
// Draws matches into their image.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/drawing.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc {

/// The first of `reasons` without its details, after a line break; "" if there are none.
std::string brief_reason(const std::vector<std::string>& reasons);

/// Outline, axes and "name score": blue when graspable, orange and "ambiguous" with the
/// reason, or grey and "unsure".
Marking marking_of(const Match& match);

/// CV_8UC3 copy of `image` with every match marked.
cv::Mat draw_matches(const cv::Mat& image, const std::vector<Match>& matches);

}  // namespace mbncc
