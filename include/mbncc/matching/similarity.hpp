// SPDX-License-Identifier: BSD-3-Clause
// Map-based normalized cross correlation: only map pixels are correlated (the paper,
// doi 10.1177/1687814017728839).
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc {

/// Variance of image noise [grey^2], added to the denominator so that places without texture get
/// a similarity near 0 instead of the correlation of their noise.
constexpr double kNoiseVariance = 16;

/// Grey values of a template under its map, as points relative to an anchor.
struct MaskedTemplate {
  std::vector<float> x, y;    ///< [px] relative to the anchor, template axes
  std::vector<float> values;  ///< [grey levels]

  std::size_t size() const { return values.size(); }
};

/// Points of `grey` (CV_8UC1) where `map` (CV_8UC1, binary, same size) is set; at level > 0 the
/// map-weighted means of 2^level squares at least half inside the map. `anchor` [px, level 0] is
/// the origin. Throws std::invalid_argument if the sizes of the images differ.
MaskedTemplate masked_template(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor,
                               int level = 0);

struct Similarity {
  double value = 0;    ///< [-1..1]; 0 where less than a quarter of the template is visible
  double visible = 0;  ///< [0..1] part of the points inside the image
};

/// Similarity of the template with `grey` (CV_8UC1) when the anchor is at `pose` and the template
/// is rotated by pose.theta. Points outside the image are ignored.
Similarity similarity(const MaskedTemplate& points, const cv::Mat& grey, const Pose2D& pose,
                      double noise_variance = kNoiseVariance);

}  // namespace mbncc
