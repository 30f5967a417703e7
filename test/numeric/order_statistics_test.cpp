// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/order_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace mbncc::numeric {
namespace {

using Draw = float (*)(std::mt19937&);

float whole(std::mt19937& random) {
  return static_cast<float>(random() % 7);
}
float signed_value(std::mt19937& random) {
  return std::normal_distribution<float>(0, 30)(random);
}
float spread_widely(std::mt19937& random) {
  return std::exp(std::uniform_real_distribution<float>(-80, 80)(random));
}
float the_same(std::mt19937&) {
  return -2.5F;
}

class Quantile : public ::testing::TestWithParam<Draw> {};

TEST_P(Quantile, IsTheValueOfThatRank) {
  std::mt19937 random(3);
  for (const std::size_t count : {1, 2, 199, 200, 201, 5000}) {
    std::vector<float> values(count);
    for (float& value : values) value = GetParam()(random);
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (const double part : {0.0, 0.1, 0.5, 0.683, 0.999, 1.0}) {
      const auto rank = std::min(count - 1, static_cast<std::size_t>(part * count));
      EXPECT_EQ(numeric::quantile(values, part), sorted[rank]) << count << " values, " << part;
    }
    std::sort(values.begin(), values.end());
    EXPECT_EQ(values, sorted);
  }
}

INSTANTIATE_TEST_SUITE_P(Draws, Quantile,
                         ::testing::Values(whole, signed_value, spread_widely, the_same));

TEST(QuantileOfNone, IsZero) {
  std::vector<float> none;
  EXPECT_EQ(numeric::quantile(none, 0.5), 0);
}

}  // namespace
}  // namespace mbncc::numeric
