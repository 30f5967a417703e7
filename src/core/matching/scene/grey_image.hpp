// SPDX-License-Identifier: BSD-3-Clause
// Checks images to search and converts them to grey.
#pragma once

#include <opencv2/core.hpp>
#include <stdexcept>

namespace mbncc::scene {

/// Throws std::invalid_argument unless `image` is CV_8UC3 (bgr) or CV_8UC1.
inline void check_type(const cv::Mat& image) {
  if (image.type() != CV_8UC3 && image.type() != CV_8UC1)
    throw std::invalid_argument("an image to search must be 8-bit colour or grey");
}

/// Like check_type(), and also throws if `image` is smaller than 16 x 16 pixels.
inline void check_searchable(const cv::Mat& image) {
  constexpr int kSmallest = 16;
  check_type(image);
  if (image.cols < kSmallest || image.rows < kSmallest)
    throw std::invalid_argument("an image to search must have at least 16 x 16 pixels");
}

/// A searchable `image` as CV_8UC1.
cv::Mat grey_image(const cv::Mat& image);

/// Whether `image` has one channel, or channels that are equal everywhere, as from a grey camera.
bool is_grey(const cv::Mat& image);

}  // namespace mbncc::scene
