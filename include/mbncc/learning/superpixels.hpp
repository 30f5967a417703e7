// SPDX-License-Identifier: BSD-3-Clause
// Superpixels: neighbouring, similar pixels gathered into cells (the paper's simplified picture).
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace mbncc {

struct Superpixels {
  cv::Mat labels;  ///< CV_32SC1, 0 .. count-1
  int count = 0;   ///< labels are below; SEEDS makes fewer superpixels than asked for
};

/// SEEDS superpixels (Van den Bergh et al.) of a CV_8UC3 picture of at least 8 x 8 pixels.
/// `wanted` is brought into what the picture can hold: cells of 4 x 4 pixels or more.
Superpixels seeds_superpixels(const cv::Mat& picture, int wanted);

/// SLIC superpixels (Achanta et al.) likewise; about `wanted` of them.
Superpixels slic_superpixels(const cv::Mat& picture, int wanted);

/// By "seeds" or "slic"; std::invalid_argument for another method.
Superpixels superpixels_of(const cv::Mat& picture, const std::string& method, int wanted);

/// Each superpixel painted in its mean colour: texture goes, the object's boundary stays.
cv::Mat simplify_superpixels(const cv::Mat& picture, const Superpixels& superpixels);

/// 255 on the superpixels of which more than half lies in `region` (CV_8UC1), 0 elsewhere.
cv::Mat superpixels_inside(const Superpixels& superpixels, const cv::Mat& region);

}  // namespace mbncc
