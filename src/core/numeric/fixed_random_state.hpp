// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's clusters start from the thread's random state: fixed, the same input gives the same
// clusters.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Gives the caller's state back at the end.
class FixedRandomState {
 public:
  FixedRandomState() : saved_(cv::theRNG()) { cv::setRNGSeed(1); }
  ~FixedRandomState() { cv::theRNG() = saved_; }
  FixedRandomState(const FixedRandomState&) = delete;
  FixedRandomState& operator=(const FixedRandomState&) = delete;

 private:
  cv::RNG saved_;
};

}  // namespace mbncc
