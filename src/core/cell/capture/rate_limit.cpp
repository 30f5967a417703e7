// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/rate_limit.hpp"

#include <algorithm>

namespace mbncc {
namespace {

// [images] Most credit; with less, images that arrive unevenly would be lost.
constexpr double kMostSaved = 2.5;
constexpr double kRounding = 1 - 1e-6;  // credit of one image, reduced by rounding errors

}  // namespace

double RateLimit::credit(double stamp, double rate) const {
  return any_ ? std::min(kMostSaved, saved_ + (stamp - last_) * rate) : 1;
}

bool RateLimit::allows(double stamp, double rate) const {
  return rate <= 0 || credit(stamp, rate) >= kRounding;
}

void RateLimit::note(double stamp, double rate) {
  saved_ = std::max(0.0, credit(stamp, rate) - 1);
  last_ = stamp;
  any_ = true;
}

}  // namespace mbncc
