// Detections drawn into their picture.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <opencv2/core.hpp>

namespace mbncc::nodelets {

/// CV_8UC3 copy of `picture` with outline, axes, instance and score of every object: green when
/// confirmed, amber when ambiguous, grey otherwise.
cv::Mat draw_detections(const cv::Mat& picture,
                        const mbncc_vision::DetectedObjectArray& detections);

/// CV_8UC3 of a score map (CV_32FC1, 0 .. 1): blue is 0, red is 1.
cv::Mat colour_score_map(const cv::Mat& scores);

}  // namespace mbncc::nodelets
