// SPDX-License-Identifier: BSD-3-Clause
// Colour prefilter for libraries: places where an object may lie judging by its colours alone,
// at any rotation.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "imaging/colour_bins.hpp"
#include "matching/proposal/search_mask.hpp"
#include "matching/proposal/template_bank.hpp"

namespace mbncc::proposal {

class ColourPrefilter {
 public:
  /// `surface`: image whose surface under `map` is extrapolated outwards. `anchor` [px] and
  /// `mean_width` [px]: those of the view.
  ColourPrefilter(const cv::Mat& surface, const cv::Mat& map, cv::Point2d anchor,
                  double mean_width);

  /// Rotates the map now instead of in the first call of places().
  void make_rotations() const { rotations_.make(); }

  /// The coarsest pyramid level that is used.
  int level() const { return class_level_; }

  /// Places where the colours under the map may be the object's rather than the image's. Everywhere
  /// if the object's colours are common in the image.
  SearchMask places(const imaging::ClassImages& scene) const;

  /// Per class of colour, the log-likelihood ratio [1/kUnit] of object to image.
  using LogLikelihoodRatios = std::vector<std::int8_t>;
  static constexpr int kUnit = 16;
  LogLikelihoodRatios log_likelihood_ratios(const imaging::ClassImages& scene) const;

 private:
  cv::Mat best_of_rotations(const cv::Mat& classes, const LogLikelihoodRatios& ratios) const;

  int class_level_, cell_level_;
  imaging::ColourShares shares_;
  numeric::Lazy<std::vector<RotatedKernel>> rotations_;  // at cell_level_
  int radius_ = 0;                                       // [cells]
};

}  // namespace mbncc::proposal
