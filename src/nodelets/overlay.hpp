// Detections drawn into their picture.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <opencv2/core.hpp>

namespace mbncc::nodelets {

/// CV_8UC3 copy of `picture` with outline, axes, instance and score of every object: green when
/// confirmed, amber when ambiguous, grey otherwise.
cv::Mat draw_detections(const cv::Mat& picture,
                        const mbncc_vision::DetectedObjectArray& detections);

}  // namespace mbncc::nodelets
