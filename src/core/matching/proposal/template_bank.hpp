// SPDX-License-Identifier: BSD-3-Clause
// Template bank: the template at all rotations at the coarse level, as zero-sum integer weights.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "numeric/lazy.hpp"

namespace mbncc::proposal {

/// One rotation of the template, with the pixels well inside the map only.
struct RotatedKernel {
  /// Pixels [begin, end) of one row.
  struct Run {
    int y, begin, end;
  };

  double angle = 0;                   ///< [rad]
  std::vector<cv::Point> pixels;      ///< relative to the anchor's pixel
  std::vector<std::int16_t> weights;  ///< one per pixel, sum 0
  std::vector<Run> runs;              ///< `pixels` as runs of rows
  double norm = 0;                    ///< sqrt(sum of squared weights)
};

struct TemplateBank {
  int level = 0;   ///< of the pyramid
  int radius = 0;  ///< [px at level] largest distance of a pixel from the anchor in x or y
  numeric::Lazy<std::vector<RotatedKernel>> kernels;  ///< evenly spaced over a turn

  /// Whether the bank is used for the search. Thin objects would be correlated at finer levels,
  /// which takes up to the time of one cv::matchTemplate and found nothing in drawn images.
  bool searched() const { return level >= 2; }
};

/// Chooses the coarsest level at which the map keeps enough pixels at every rotation, and the
/// rotation step by the arc that the rim moves. `anchor` [px] is the centre of rotation. No
/// kernels, at level 0, for a map so long and thin that they would be too many and too large.
TemplateBank rotated_kernels(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor);

/// The map at `level` and at `count` rotations, without weights: the pixels that it covers by at
/// least half, or by at least a quarter if the map is narrower than a pixel.
TemplateBank turned_maps(const cv::Mat& map, cv::Point2d anchor, int level, int count);

}  // namespace mbncc::proposal
