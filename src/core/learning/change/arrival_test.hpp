// SPDX-License-Identifier: BSD-3-Clause
// Classifies changed patches as the place that the object left or as arrivals. The image before
// shows the object only at the place that it left.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"

namespace mbncc::change {

/// 255 on the connected patches of `changed` (CV_8UC1) that are certain arrivals and score clearly
/// lower than the best other patch. Images are CV_32FC3, aligned; `platform` is the colour
/// mixture of the ring. An empty mixture gives no arrivals.
cv::Mat find_arrivals(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const ColourMixture& platform);

/// Score [1] of a departure from the patch `label` of `labels` against an arrival: its pixels look
/// more like platform afterwards, and its border is an edge only before. Departures score about +2
/// .. +7, arrivals -1 .. -7. Index 0 (no patch) is 0.
std::vector<double> departure_scores(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Mat& labels, int count,
                                     const ColourMixture& platform);

/// Evidence of a departure in whole images (CV_8UC3) without a given region: CV_32FC1 of their
/// size, above 0 on the patches of `changed` (CV_8UC1) except arrivals. An arrival is not in the
/// image before, so a lesson on it would teach bare platform. Computed at about 320 pixels width.
cv::Mat departures(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed);

}  // namespace mbncc::change
