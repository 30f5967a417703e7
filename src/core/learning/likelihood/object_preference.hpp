// SPDX-License-Identifier: BSD-3-Clause
// Log-odds of object against platform from each pixel's colour and surroundings.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/colour_mixture.hpp"

namespace mbncc::likelihood {

constexpr float kHighestPreference = 60;

/// Density of each pixel of `image` (CV_32FC3) relative to the uniform one, CV_32FC1.
cv::Mat relative_density(const change::ColourMixture& mixture, const cv::Mat& image);

/// Weights of the pixels of `map` (CV_8UC1) for the object's colours, CV_32FC1 [0..1]. `changed`
/// is BackgroundLikelihood's.
cv::Mat colour_weights(const cv::Mat& changed, const cv::Mat& map);

/// Log-odds of the object in `before` (CV_32FC3), CV_32FC1 of at most +-kHighestPreference.
/// `background` is BackgroundLikelihood's log_ratio, `last_map` is the previous cut (CV_8UC1),
/// empty if there was none.
cv::Mat object_preference(const cv::Mat& before, const change::ColourMixture& object,
                          const cv::Mat& background, const cv::Mat& last_map);

}  // namespace mbncc::likelihood
