// SPDX-License-Identifier: BSD-3-Clause
// Reliability measures of a finished cut.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "learning/segmentation/smoothness.hpp"
#include "mbncc/learning/cut_evidence.hpp"

namespace mbncc::segmentation {

/// Images of one crop.
struct FinishedCut {
  cv::Mat map;          ///< CV_8UC1
  cv::Mat coarse;       ///< CV_8UC1, the cut of `unary` at half resolution
  cv::Mat inside;       ///< CV_8UC1, 255 in the region
  cv::Mat unary;        ///< CV_32FC1, unary term of the last cut
  cv::Mat changed;      ///< CV_32FC1, as in BackgroundLikelihood
  cv::Mat object_like;  ///< CV_8UC1, surely object by the unary term; outside the region as well
  cv::Mat kept;         ///< CV_8UC1 or empty: groups with a pixel there belong to the object
  cv::Mat intruders;    ///< CV_8UC1 or empty: covered afterwards by something from outside
  cv::Mat confirmed;    ///< CV_8UC1 or empty: near the operator's strokes
};

/// Part [0..1] of the map's outline within two pixels of the region's edge, or beyond.
double region_touch(const cv::Mat& map, const cv::Mat& inside);

/// Width or height of the map's box as a part [0..1] of the region's box, whichever part is less.
double region_span(const cv::Mat& map, const cv::Mat& inside);

/// How well the outline lies on image edges, or how little it depends on shifted log-odds,
/// whichever is less [0..1].
inline double edge_clarity(const CutEvidence& evidence) {
  return std::min(evidence.boundary_contrast, evidence.stability);
}

CutEvidence cut_evidence(const FinishedCut& cut, const Smoothness& smoothness,
                         const Smoothness& half);

}  // namespace mbncc::segmentation
