// SPDX-License-Identifier: BSD-3-Clause
// What an excluding stroke says about pixels that it does not cover: what looks like them leaves.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// A cut and what it was made of; pictures of one crop.
struct CutPictures {
  cv::Mat before;  ///< CV_32FC3
  cv::Mat after;   ///< CV_32FC3, aligned with `before`
  cv::Mat unary;   ///< CV_32FC1, log-odds of object against platform
  cv::Mat map;     ///< CV_8UC1, 0 or 255
};

/// Log-odds (CV_32FC1), within +-10, that a pixel of the map is no more the object's than the
/// `excluded` ones (CV_8UC1 of the crop's size): positive where it looks more like them, and like
/// what likely belongs to them, than like the rest of the map, in its colours and in how they
/// changed; less inside the map than along its outline. 0 on other pixels.
cv::Mat exclusion_votes(const CutPictures& cut, const cv::Mat& excluded);

}  // namespace mbncc
