// SPDX-License-Identifier: BSD-3-Clause
// Detections drawn into their image.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <opencv2/core.hpp>

namespace mbncc::nodelets {

/// CV_8UC3: a copy of `image` with outline, axes, name, instance, score and state of every object
/// (blue confirmed, orange ambiguous, grey otherwise), and a legend with the image's age below
/// it.
cv::Mat draw_detections(const cv::Mat& image, const mbncc_vision::DetectedObjectArray& detections);

/// A score map (CV_32FC1, 0 .. 1) in colours, CV_8UC3: dark blue is 0, yellow is 1.
cv::Mat colour_score_map(const cv::Mat& scores);

/// colour_score_map() with a ring around the best place and a square around the best one farther
/// than `radius` [px] from it. Without numbers, because these similarities are not scores.
cv::Mat draw_score_map(const cv::Mat& scores, double radius);

}  // namespace mbncc::nodelets
