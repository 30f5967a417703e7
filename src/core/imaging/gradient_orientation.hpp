// SPDX-License-Identifier: BSD-3-Clause
// Orientation and strength of the colour edges of an image, independent of which side is brighter.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::imaging {

/// Largest length of an edge vector.
constexpr int kEdgeScale = 127;

/// CV_16SC2: gradient of the channel with the strongest one, in eighths of a grey level per pixel.
/// `image` is CV_8UC3.
cv::Mat strongest_gradient(const cv::Mat& image);

/// Writes the `region` of two images of the same size as `image` (CV_8UC3): `smooth` (CV_8UC3) is
/// `image` filtered by a Gaussian of `sigma` [px] over 5 x 5 pixels; `edges` (CV_8SC2) is derived
/// from the strongest gradient of `smooth`. For a gradient of magnitude m [grey levels per pixel]
/// and direction a, where the brightest channel of `smooth` is v, it contains the vector kEdgeScale
/// m / (m + 2.5 + v / 80) (cos 2a, sin 2a). Light scales m and v alike, so an edge is almost as
/// long in a shadow as in the light; the 2.5 suppresses noise. The vector's scalar product with
/// (cos 2b, sin 2b) is the response to an edge whose normal has direction b: positive if aligned,
/// negative if crossing, near zero where the gradient is weak. Clutter averages to zero. The
/// image's border is replicated; the result does not depend on the region.
void smooth_and_find_edges(const cv::Mat& image, const cv::Rect& region, double sigma,
                           cv::Mat& smooth, cv::Mat& edges);

}  // namespace mbncc::imaging
