// SPDX-License-Identifier: BSD-3-Clause
// Procedural surfaces.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace mbncc::sim {

/// CV_32FC1 noise of mean 0 and standard deviation 1: octaves with features from `coarsest` down to
/// `finest` [px]; the amplitude is proportional to the square root of the feature size.
cv::Mat fractal_noise(cv::Size size, double coarsest, double finest, cv::RNG& random);

/// CV_32FC3 [grey levels] surface of a worn work table: stains, grain, scratches and specks.
cv::Mat platform_texture(cv::Size size, std::uint64_t seed);

/// CV_32FC3 [grey levels] painted surface: two colours in patches, bands, printed marks, wear.
/// `scale` is the number of texture pixels per image pixel.
cv::Mat object_texture(cv::Size size, double scale, std::uint64_t seed);

/// bgr colour [grey levels] of hue [0..360), saturation [0..1] and value [0..255].
cv::Scalar colour_of(double hue, double saturation, double value);

}  // namespace mbncc::sim
