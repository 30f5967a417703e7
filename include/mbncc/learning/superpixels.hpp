// SPDX-License-Identifier: BSD-3-Clause
// Superpixels: cells of neighbouring, similar pixels (the paper's simplified image).
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace mbncc {

struct Superpixels {
  cv::Mat labels;  ///< CV_32SC1, 0 .. count-1
  int count = 0;   ///< labels are below this; SEEDS makes fewer superpixels than requested
};

/// SEEDS superpixels (Van den Bergh et al.) of a CV_8UC3 image of at least 8 x 8 pixels.
/// `wanted` is limited so that cells have at least 4 x 4 pixels.
Superpixels seeds_superpixels(const cv::Mat& image, int wanted);

/// SLIC superpixels (Achanta et al.), about `wanted` of them.
Superpixels slic_superpixels(const cv::Mat& image, int wanted);

/// Superpixels by `method` "seeds" or "slic"; throws std::invalid_argument for another method.
Superpixels superpixels_of(const cv::Mat& image, const std::string& method, int wanted);

/// Paints each superpixel in its mean colour, which removes texture and keeps the object's
/// boundary.
cv::Mat simplify_superpixels(const cv::Mat& image, const Superpixels& superpixels);

/// 255 on the superpixels of which more than half lies in `region` (CV_8UC1), 0 elsewhere.
cv::Mat superpixels_inside(const Superpixels& superpixels, const cv::Mat& region);

}  // namespace mbncc
