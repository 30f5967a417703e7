// SPDX-License-Identifier: BSD-3-Clause
// Scores changed patches: the place that the object left against an arrival. The image before
// shows the object only at the place that it left.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "learning/change/colour_mixture.hpp"

namespace mbncc::change {

/// Per patch of `labels` (CV_32SC1, 0 .. `count` - 1), the score [1] of a departure as opposed to
/// an arrival: after a departure, the patch looks more like the platform, and its border is an edge
/// only before. Departures score about +2 .. +7, arrivals -1 .. -7. Index 0 (no patch) is 0.
std::vector<double> departure_scores(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Mat& labels, int count,
                                     const ColourMixture& platform);

}  // namespace mbncc::change
