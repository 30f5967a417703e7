// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <vector>

#include "simd/kernels_fixture.hpp"

namespace mbncc::kernels {
namespace {

TEST_P(Kernels, DotsEqualReference) {
  constexpr int kRows = 5;
  const int padded = (count() + kLanes - 1) / kLanes * kLanes;
  std::vector<float> values(kRows * padded + misalignment() + padded);
  std::normal_distribution<float> value(0, 30);
  for (auto& v : values) v = value(random_);
  const float* rows = values.data() + misalignment();
  const float* vector = values.data() + kRows * padded;
  std::vector<float> expected(kRows), actual(kRows);
  reference().dots_rows(rows, padded, kRows, vector, padded, expected.data());
  for (const auto& target : targets()) {
    target.table->dots_rows(rows, padded, kRows, vector, padded, actual.data());
    EXPECT_EQ(expected, actual) << target.name;
  }
}

TEST_P(Kernels, DotPairsEqualReference) {
  constexpr int kPairs = 6;
  const int padded = (count() + kLanes - 1) / kLanes * kLanes;
  std::vector<float> values((kPairs + 1) * padded + misalignment());
  std::normal_distribution<float> value(0, 30);
  for (auto& v : values) v = value(random_);
  const float *a[kPairs], *b[kPairs];
  for (int k = 0; k < kPairs; ++k) {
    a[k] = values.data() + misalignment() + k * padded;
    b[k] = a[k / 2] + padded;
  }
  std::vector<float> expected(kPairs), actual(kPairs);
  reference().dot_pairs_rows(a, b, kPairs, padded, expected.data());
  for (const auto& target : targets()) {
    target.table->dot_pairs_rows(a, b, kPairs, padded, actual.data());
    EXPECT_EQ(expected, actual) << target.name;
  }
}

INSTANTIATE_TEST_SUITE_P(OddSizesAndMisalignments, Kernels, odd_sizes_and_misalignments());

}  // namespace
}  // namespace mbncc::kernels
