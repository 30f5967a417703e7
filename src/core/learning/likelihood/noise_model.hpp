// SPDX-License-Identifier: BSD-3-Clause
// Noise model of two images of the same unchanged surface, estimated from the images.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "learning/alignment/align_images.hpp"

namespace mbncc::likelihood {

/// Variance of before - after on unchanged platform:
///   sigma(channel, brightness)^2 + gradient_part |gradient|^2,
/// where the second term models a residual shift of a fraction of a pixel. Compression and
/// demosaicing correlate the channels' errors, so a change of colour is more significant than one
/// of brightness.
struct NoiseModel {
  static constexpr int kBins = 16;  ///< bins of brightness, 16 grey levels each
  using Channel = std::array<float, kBins>;

  std::array<Channel, 3> variance{};             ///< [grey levels^2]
  float gradient_part = 0.01F;                   ///< [px^2]
  cv::Matx33f correlation = cv::Matx33f::eye();  ///< of the channels' differences
  float tail = 1;  ///< [1..4] factor on the variance: tails heavier than normal

  /// Variance per channel where `after` (CV_32FC3) is the unchanged surface.
  cv::Vec3f variance_at(const cv::Mat& after, int y, int x) const;

  /// Variance per channel for all pixels, CV_32FC3.
  cv::Mat variance_image(const cv::Mat& after) const;

  /// Standard deviation of a channel, averaged over brightness. [grey levels]
  float sigma(int channel) const;
};

/// Learns the model from the trusted pixels of the pair.
NoiseModel learn_noise(const alignment::AlignedPair& pair);

}  // namespace mbncc::likelihood
