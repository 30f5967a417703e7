// SPDX-License-Identifier: BSD-3-Clause
// Which changed patches are the place that the object left, and which are places where something
// arrived? The object is in the picture before only where it left.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"

namespace mbncc {

/// 255 on the connected patches of `changed` (CV_8UC1) that are arrivals beyond doubt and clearly
/// more so than the best other patch. Pictures are CV_32FC3, aligned; `platform` is the colour
/// mixture of the ring. An empty mixture gives no arrivals.
cv::Mat find_arrivals(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const ColourMixture& platform);

/// How much rather something left the patch `label` of `labels` than arrived there [1]: its pixels
/// look more like platform afterwards, its border was an edge before and is none afterwards.
/// Departures score about +2 .. +7, arrivals -1 .. -7. Index 0 (no patch) is 0.
std::vector<double> departure_scores(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Mat& labels, int count,
                                     const ColourMixture& platform);

/// How surely something left, for whole pictures (CV_8UC3) that nobody has marked a region in:
/// CV_32FC1 of their size, above 0 on the patches of `changed` (CV_8UC1) but those where something
/// arrived. What was put down there is not in the picture before, and a lesson on it would teach
/// bare platform. Judged at about 320 pixels width.
cv::Mat departures(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed);

}  // namespace mbncc
