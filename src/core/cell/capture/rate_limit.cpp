// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/rate_limit.hpp"

#include <algorithm>

namespace mbncc {
namespace {

constexpr double kMostSaved = 2.5;      // images; fewer would lose some if they arrive unevenly
constexpr double kRounding = 1 - 1e-6;  // of one

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
