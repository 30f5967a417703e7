// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/weighted_median.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace mbncc::numeric {
namespace {

/// The weighted median by its definition.
float least_with_half_of_the_weight(std::vector<Weighted> values) {
  std::sort(values.begin(), values.end());
  double total = 0, below = 0;
  for (const auto& one : values) total += one.second;
  for (const auto& one : values)
    if ((below += one.second) >= total / 2) return one.first;
  return 0;
}

TEST(WeightedMedian, IsTheLeastValueWithHalfOfTheWeight) {
  std::mt19937 random(1);
  // The ranges are small, so that many values are equal.
  std::uniform_int_distribution<int> count(1, 40), value(-20, 20), weight(1, 8);
  for (int round = 0; round < 500; ++round) {
    std::vector<Weighted> values(count(random));
    for (auto& one : values) one = {value(random), weight(random)};
    const float expected = least_with_half_of_the_weight(values);
    EXPECT_EQ(weighted_median(values), expected) << round;
  }
}

TEST(WeightedMedian, IsZeroWithoutValues) {
  std::vector<Weighted> none;
  EXPECT_EQ(weighted_median(none), 0);
}

}  // namespace
}  // namespace mbncc::numeric
