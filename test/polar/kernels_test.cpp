#include "polar/kernels.hpp"

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

TEST_P(Kernels, SumRowsMaxEqualsReference) {
  constexpr int kRows = 10;
  const auto maps = random_values<std::int16_t>(count() + kRows * 3 + misalignment(), -1000, 1000);
  std::vector<const std::int16_t*> rows;
  for (int k = 0; k < kRows; ++k) rows.push_back(maps.data() + misalignment() + 3 * k);
  const auto best = random_values<std::int16_t>(count(), -2000, 2000);
  auto best_expected = best, best_actual = best;
  std::vector<std::int16_t> expected(count()), actual(count());
  reference().sum_rows_max_row(rows.data(), kRows, expected.data(), best_expected.data(), count());
  vectorised().sum_rows_max_row(rows.data(), kRows, actual.data(), best_actual.data(), count());
  EXPECT_EQ(expected, actual);
  EXPECT_EQ(best_expected, best_actual);
}

TEST_P(Kernels, StrongestOfThreeEqualsReference) {
  const auto x = random_values<std::int16_t>(3 * count() + misalignment(), -1024, 1024);
  const auto y = random_values<std::int16_t>(3 * count() + misalignment(), -1024, 1024);
  std::vector<std::int16_t> expected(2 * count()), actual(2 * count());
  reference().strongest_of_three_row(x.data() + misalignment(), y.data() + misalignment(),
                                     expected.data(), count());
  vectorised().strongest_of_three_row(x.data() + misalignment(), y.data() + misalignment(),
                                      actual.data(), count());
  EXPECT_EQ(expected, actual);
}

TEST_P(Kernels, EdgeVectorsEqualReference) {
  const auto gradients = random_values<std::int16_t>(2 * count() + misalignment(), -1024, 1024);
  std::vector<std::int8_t> expected(2 * count()), actual(2 * count());
  reference().edge_vectors_row(gradients.data() + misalignment(), expected.data(), count());
  vectorised().edge_vectors_row(gradients.data() + misalignment(), actual.data(), count());
  EXPECT_EQ(expected, actual);
}

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
  vectorised().dots_rows(rows, padded, kRows, vector, padded, actual.data());
  EXPECT_EQ(expected, actual);
}

TEST_P(Kernels, NormaliseEqualsReference) {
  const auto numerators = random_values<std::int32_t>(count(), -300000, 300000);
  const auto sums = random_values<std::int32_t>(count(), -4000, 4000);
  const auto squares = random_values<std::int32_t>(count(), 400000, 900000);
  const Normalisation terms{0.004f, 60.f, 960.f, 0.3f};
  std::vector<float> best_expected(count(), -1), gates_expected(count(), 0);
  auto best_actual = best_expected, gates_actual = gates_expected;
  reference().normalise_row(numerators.data(), sums.data(), squares.data(), terms,
                            best_expected.data(), gates_expected.data(), count());
  vectorised().normalise_row(numerators.data(), sums.data(), squares.data(), terms,
                             best_actual.data(), gates_actual.data(), count());
  EXPECT_EQ(best_expected, best_actual);
  EXPECT_EQ(gates_expected, gates_actual);
}

TEST_P(Kernels, AnyAboveEqualsReference) {
  auto values = random_values<std::int32_t>(count(), -1000, 0);
  const std::vector<float> gates(count(), 10);
  EXPECT_FALSE(reference().any_above_row(values.data(), 0.5f, gates.data(), count()));
  EXPECT_FALSE(vectorised().any_above_row(values.data(), 0.5f, gates.data(), count()));
  values.back() = 21;
  EXPECT_TRUE(reference().any_above_row(values.data(), 0.5f, gates.data(), count()));
  EXPECT_TRUE(vectorised().any_above_row(values.data(), 0.5f, gates.data(), count()));
}

INSTANTIATE_TEST_SUITE_P(OddSizesAndMisalignments, Kernels,
                         ::testing::Combine(::testing::Values(1, 3, 7, 16, 31, 64, 97, 160, 333),
                                            ::testing::Values(0, 1, 3, 7)));

}  // namespace
}  // namespace mbncc::kernels
