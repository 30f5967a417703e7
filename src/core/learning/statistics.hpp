// Order statistics.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mbncc {

/// Value below which the part `q` [0..1] of `values` lies; 0 for none. Reorders `values`.
inline float quantile(std::vector<float>& values, double q) {
  if (values.empty()) return 0;
  const auto rank = std::min(values.size() - 1, static_cast<std::size_t>(q * values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

inline float median(std::vector<float>& values) {
  return quantile(values, 0.5);
}

/// Standard deviation of a normal distribution with this median absolute deviation.
inline float deviation_of_mad(float mad) {
  return 1.4826F * mad;
}

}  // namespace mbncc
