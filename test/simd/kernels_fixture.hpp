// SPDX-License-Identifier: BSD-3-Clause
// Inputs for which every version of a kernel must give the same result.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <tuple>
#include <vector>

#include "simd/kernels.hpp"

namespace mbncc::kernels {

/// Random input at the limits of the contract, starting `misalignment` elements into its buffer.
class Kernels : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int count() const { return std::get<0>(GetParam()); }
  int misalignment() const { return std::get<1>(GetParam()); }

  int whole_groups() const { return (count() + kPositions - 1) / kPositions * kPositions; }

  template <class T>
  std::vector<T> random_values(std::size_t size, int low, int high) {
    std::uniform_int_distribution<int> value(low, high);
    std::vector<T> values(size);
    for (auto& v : values) v = static_cast<T>(value(random_));
    return values;
  }

  std::mt19937 random_{7};
};

inline auto odd_sizes_and_misalignments() {
  return ::testing::Combine(::testing::Values(1, 3, 7, 16, 31, 64, 97, 160, 333),
                            ::testing::Values(0, 1, 3, 7));
}

}  // namespace mbncc::kernels
