// SPDX-License-Identifier: BSD-3-Clause
// Mask of the places to search.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::proposal {

class SearchMask {
 public:
  /// Everywhere.
  SearchMask() = default;
  /// Where `mask`, CV_8UC1 at pyramid level `level`, is not 0.
  SearchMask(cv::Mat mask, int level) : mask_(std::move(mask)), level_(level) {}

  bool everywhere() const { return mask_.empty(); }

  /// CV_8UC1 of size `count`: 255 at the positions `first` + `step` * (column, row) [px at `level`]
  /// inside the mask, otherwise 0.
  cv::Mat of_positions(int level, cv::Point first, int step, cv::Size count) const;

 private:
  cv::Mat mask_;
  int level_ = 0;
};

}  // namespace mbncc::proposal
