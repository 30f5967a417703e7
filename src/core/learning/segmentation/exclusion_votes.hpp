// SPDX-License-Identifier: BSD-3-Clause
// Extends an excluding stroke to pixels of similar appearance.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::segmentation {

/// A cut with its input; images of one crop.
struct CutImages {
  cv::Mat before;  ///< CV_32FC3
  cv::Mat after;   ///< CV_32FC3, aligned with `before`
  cv::Mat unary;   ///< CV_32FC1, log-odds of object against platform
  cv::Mat map;     ///< CV_8UC1, 0 or 255
};

/// Log-odds (CV_32FC1), within +-10, that a pixel of the map belongs to the same structure as the
/// `excluded` ones (CV_8UC1 of the crop's size): positive if its colour and change resemble those
/// pixels more than the rest of the map; lower inside the map than along its outline. 0 on other
/// pixels.
cv::Mat exclusion_votes(const CutImages& cut, const cv::Mat& excluded);

}  // namespace mbncc::segmentation
