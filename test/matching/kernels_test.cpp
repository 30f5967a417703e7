#include "matching/kernels.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace mbncc::kernels {
namespace {

/// Random input at the contract's bounds, starting `misalignment` elements into its buffer.
class Kernels : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int count() const { return std::get<0>(GetParam()); }
  int misalignment() const { return std::get<1>(GetParam()); }

  template <class T>
  std::vector<T> random_values(std::size_t size, int low, int high) {
    std::uniform_int_distribution<int> value(low, high);
    std::vector<T> values(size);
    for (auto& v : values) v = static_cast<T>(value(random_));
    return values;
  }

  std::mt19937 random_{7};
};

TEST_P(Kernels, CorrelateEqualsReference) {
  constexpr int kTerms = 5 * kTermGroup, kReach = 40;
  const auto picture =
      random_values<std::int16_t>(count() + kReach + misalignment(), -kMaxPicture, kMaxPicture);
  const auto offsets = random_values<std::int32_t>(kTerms, 0, kReach - 1);
  const auto weights = random_values<std::int16_t>(kTerms, -kMaxWeight, kMaxWeight);
  std::vector<std::int32_t> expected(count()), actual(count());
  const auto run = [&](const Table& table, std::vector<std::int32_t>& sums) {
    table.correlate_row(picture.data() + misalignment(), offsets.data(), weights.data(), kTerms,
                        sums.data(), count());
  };
  run(reference(), expected);
  run(vectorised(), actual);
  EXPECT_EQ(expected, actual);
}

TEST_P(Kernels, CorrelateBearsItsBounds) {
  const std::vector<std::int16_t> picture(count() + misalignment(), -kMaxPicture);
  const std::vector<std::int32_t> offsets(kTermGroup, misalignment());
  const std::vector<std::int16_t> weights(kTermGroup, kMaxWeight);
  std::vector<std::int32_t> sums(count());
  vectorised().correlate_row(picture.data(), offsets.data(), weights.data(), kTermGroup,
                             sums.data(), count());
  EXPECT_EQ(sums, std::vector<std::int32_t>(count(), -kTermGroup * kMaxPicture * kMaxWeight));
}

TEST_P(Kernels, SumRunsEqualsReference) {
  constexpr int kRuns = 9, kReach = 60;
  auto prefix = random_values<std::int32_t>(count() + kReach + misalignment(), 0, 16384);
  std::partial_sum(prefix.begin(), prefix.end(), prefix.begin());
  const auto begins = random_values<std::int32_t>(kRuns, 0, kReach / 2);
  const auto ends = random_values<std::int32_t>(kRuns, kReach / 2, kReach - 1);
  std::vector<std::int32_t> expected(count()), actual(count());
  const auto run = [&](const Table& table, std::vector<std::int32_t>& sums) {
    table.sum_runs_row(prefix.data() + misalignment(), begins.data(), ends.data(), kRuns,
                       sums.data(), count());
  };
  run(reference(), expected);
  run(vectorised(), actual);
  EXPECT_EQ(expected, actual);
}

INSTANTIATE_TEST_SUITE_P(OddSizesAndMisalignments, Kernels,
                         ::testing::Combine(::testing::Values(1, 3, 7, 16, 31, 64, 97, 160, 333),
                                            ::testing::Values(0, 1, 3, 7)));

}  // namespace
}  // namespace mbncc::kernels
