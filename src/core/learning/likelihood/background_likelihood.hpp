// SPDX-License-Identifier: BSD-3-Clause
// Likelihood of the image before given the unchanged, possibly shadowed platform.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"
#include "learning/likelihood/noise_model.hpp"

namespace mbncc::likelihood {

/// Densities are relative to that of a colour drawn uniformly from all 8-bit colours.
struct BackgroundLikelihood {
  cv::Mat log_ratio;  ///< CV_32FC1: log of p(before | background) / uniform
  cv::Mat changed;    ///< CV_32FC1 [0..1] probability that the pixel shows something else
};

/// log of the uniform density over 8-bit colours.
float log_uniform_colour();

constexpr float kDarkestShadow =
    /// [0..1] Least light that a shadow in either image leaves.
    0.3F;

/// `before` and `after` are CV_32FC3, aligned. `platform` is the ring's colour mixture; it may be
/// empty.
BackgroundLikelihood background_likelihood(const cv::Mat& before, const cv::Mat& after,
                                           const NoiseModel& noise,
                                           const change::ColourMixture& platform,
                                           float darkest_shadow = kDarkestShadow);

}  // namespace mbncc::likelihood
