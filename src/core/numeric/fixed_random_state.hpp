// SPDX-License-Identifier: BSD-3-Clause
// Fixes OpenCV's thread-local random state, so that clustering is deterministic.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::numeric {

/// The destructor restores the caller's state.
class FixedRandomState {
 public:
  FixedRandomState() : saved_(cv::theRNG()) { cv::setRNGSeed(1); }
  ~FixedRandomState() { cv::theRNG() = saved_; }
  FixedRandomState(const FixedRandomState&) = delete;
  FixedRandomState& operator=(const FixedRandomState&) = delete;

 private:
  cv::RNG saved_;
};

}  // namespace mbncc::numeric
