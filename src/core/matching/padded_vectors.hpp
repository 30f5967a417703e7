// Arithmetic on vectors padded with zeros to whole lanes (see polar/kernels.hpp).
#pragma once

#include <vector>

#include "polar/kernels.hpp"

namespace mbncc {

/// `count` rounded up to whole lanes.
inline std::size_t whole_lanes(std::size_t count) {
  return (count + kernels::kLanes - 1) / kernels::kLanes * kernels::kLanes;
}

/// Scalar product with `b`, which has as many values.
inline double product(const std::vector<float>& a, const float* b) {
  float sum = 0;
  kernels::dots(a.data(), a.size(), 1, b, static_cast<int>(a.size()), &sum);
  return sum;
}

/// from -= factor * what.
inline void subtract(std::vector<float>& from, double factor, const float* what) {
  for (std::size_t i = 0; i < from.size(); ++i) from[i] -= static_cast<float>(factor) * what[i];
}

}  // namespace mbncc
