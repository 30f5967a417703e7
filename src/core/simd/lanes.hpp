// SPDX-License-Identifier: BSD-3-Clause
// Arithmetic on vectors padded with zeros to whole lanes (see kernels.hpp).
#pragma once

#include <array>
#include <vector>

#include "simd/kernels.hpp"

namespace mbncc::kernels {

/// `count` rounded up to whole lanes.
inline std::size_t whole_lanes(std::size_t count) {
  return (count + kLanes - 1) / kLanes * kLanes;
}

/// Scalar product with `b`, which has the same number of values.
inline double product(const std::vector<float>& a, const float* b) {
  float sum = 0;
  dots(a.data(), a.size(), 1, b, static_cast<int>(a.size()), &sum);
  return sum;
}

/// Scalar products of pairs of vectors of `count` values, several at a time.
template <std::size_t kPairs>
std::array<float, kPairs> products(const std::array<const float*, kPairs>& a,
                                   const std::array<const float*, kPairs>& b, std::size_t count) {
  std::array<float, kPairs> found;
  dot_pairs(a.data(), b.data(), static_cast<int>(kPairs), static_cast<int>(count), found.data());
  return found;
}

/// Computes from -= factor * what.
inline void subtract(std::vector<float>& from, double factor, const float* what) {
  for (std::size_t i = 0; i < from.size(); ++i) from[i] -= static_cast<float>(factor) * what[i];
}

}  // namespace mbncc::kernels
