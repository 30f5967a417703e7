// SPDX-License-Identifier: BSD-3-Clause
// Where an object may lie in a picture by its colours alone, whatever its rotation: the gate before
// any search, for libraries.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "imaging/colour_bins.hpp"
#include "matching/proposal/search_mask.hpp"
#include "matching/proposal/template_bank.hpp"

namespace mbncc {

class ColourPrefilter {
 public:
  /// `surface` is the picture under `map`, continued outwards; `anchor` [px] as of the view.
  ColourPrefilter(const cv::Mat& surface, const cv::Mat& map, cv::Point2d anchor,
                  double mean_width);

  /// Turns the map now rather than when places() first asks for it.
  void make_rotations() const { rotations_.make(); }

  /// Of the pyramid, the coarsest that is looked at.
  int level() const { return class_level_; }

  /// Where the colours under the map speak for the object rather than for the picture as a whole.
  /// Everywhere, when the picture has the object's colours all over.
  SearchMask places(const ClassPictures& scene) const;

  /// Per class of colour, log-odds [1/kUnit] that it is the object's rather than the picture's.
  using Speaking = std::vector<std::int8_t>;
  static constexpr int kUnit = 16;
  Speaking speaking(const ClassPictures& scene) const;

 private:
  cv::Mat best_of_rotations(const cv::Mat& classes, const Speaking& speaking) const;

  int class_level_, cell_level_;
  ColourShares shares_;
  Lazy<std::vector<RotatedKernel>> rotations_;  // at cell_level_
  int radius_ = 0;                              // [cells]
};

}  // namespace mbncc
