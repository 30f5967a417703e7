// SPDX-License-Identifier: BSD-3-Clause
// Order statistics.
#pragma once

#include <vector>

namespace mbncc::numeric {

/// Value below which the part `q` [0..1] of `values` lies; 0 for none. No value may be NaN.
/// Reorders `values`.
float quantile(std::vector<float>& values, double q);

/// Of an even number of values the upper one in the middle; 0 for none. Reorders `values`.
inline float median(std::vector<float>& values) {
  return quantile(values, 0.5);
}

/// Standard deviation of a normal distribution with this median absolute deviation.
inline float deviation_of_mad(float mad) {
  return 1.4826F * mad;
}

}  // namespace mbncc::numeric
