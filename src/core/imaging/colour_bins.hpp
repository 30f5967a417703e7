// SPDX-License-Identifier: BSD-3-Clause
// Colour bins of chroma and brightness, for likelihood ratios of object and background.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::imaging {

constexpr int kChromaClasses = 16;     ///< of ln R/G, and of ln B/G
constexpr int kBrightnessClasses = 8;  ///< of the mean logarithm of the channels
constexpr int kColourClasses = kChromaClasses * kChromaClasses * kBrightnessClasses;

/// One share per class; they sum to 1.
using ColourShares = std::vector<float>;

/// Class of each pixel, CV_16UC1, of an image, CV_8UC3 (bgr).
cv::Mat colour_classes(const cv::Mat& image);

/// Shares of the pixels where `mask` is not 0; blurred by about one class, because light changes
/// colours.
ColourShares colour_shares(const cv::Mat& classes, const cv::Mat& mask = {});

/// An image's classes at several levels of its pyramid.
class ClassImages {
 public:
  static constexpr int kFirst = 1, kLast = 3;  ///< levels, unless the pyramid has fewer

  /// `pyramid` starts at level 0; each level is CV_8UC3.
  explicit ClassImages(const std::vector<cv::Mat>& pyramid);

  int last_level() const { return kFirst + static_cast<int>(levels_.size()) - 1; }
  const cv::Mat& at(int level) const { return levels_[level - kFirst]; }
  const ColourShares& shares() const { return shares_; }

 private:
  std::vector<cv::Mat> levels_;
  ColourShares shares_;
};

}  // namespace mbncc::imaging
