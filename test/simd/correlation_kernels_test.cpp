// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>
#include <vector>

#include "simd/kernels_fixture.hpp"

namespace mbncc::kernels {
namespace {

TEST_P(Kernels, CorrelateEqualsReference) {
  constexpr int kPairs = 21, kReach = 40;
  const int groups = whole_groups();
  const auto image =
      random_values<std::int16_t>(groups + kReach + misalignment() + 1, -kMaxImage, kMaxImage);
  const auto offsets = random_values<std::int32_t>(kPairs, 0, kReach - 1);
  const auto weights = random_values<std::int16_t>(2 * kPairs, -kMaxWeight, kMaxWeight);
  const auto run = [&](const Table& table) {
    std::vector<std::int32_t> sums(groups);
    table.correlate_row(image.data() + misalignment(), offsets.data(), weights.data(), kPairs,
                        sums.data(), groups);
    return sums;
  };
  for (const auto& target : targets())
    EXPECT_EQ(run(*target.table), run(reference())) << target.name;
}

TEST_P(Kernels, CorrelateDoesNotOverflowAtItsBounds) {
  constexpr int kPairs = 4;
  const std::vector<std::int16_t> image(whole_groups() + 1, -kMaxImage);
  const std::vector<std::int32_t> offsets(kPairs, 0);
  const std::vector<std::int16_t> weights(2 * kPairs, kMaxWeight);
  for (const auto& target : targets()) {
    std::vector<std::int32_t> sums(whole_groups());
    target.table->correlate_row(image.data(), offsets.data(), weights.data(), kPairs, sums.data(),
                                whole_groups());
    EXPECT_EQ(sums, std::vector<std::int32_t>(whole_groups(), -2 * kPairs * kMaxImage * kMaxWeight))
        << target.name;
  }
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
  for (const auto& target : targets()) {
    run(*target.table, actual);
    EXPECT_EQ(expected, actual) << target.name;
  }
}

TEST_P(Kernels, NormaliseEqualsReference) {
  const auto numerators = random_values<std::int32_t>(count(), -300000, 300000);
  const auto sums = random_values<std::int32_t>(count(), -4000, 4000);
  const auto squares = random_values<std::int32_t>(count(), 400000, 900000);
  const Normalisation terms{0.004f, 60.f, 960.f, 0.3f};
  std::vector<float> best_expected(count(), -1), gates_expected(count(), 0);
  const auto best_before = best_expected, gates_before = gates_expected;
  reference().normalise_row(numerators.data(), sums.data(), squares.data(), terms,
                            best_expected.data(), gates_expected.data(), count());
  for (const auto& target : targets()) {
    auto best_actual = best_before, gates_actual = gates_before;
    target.table->normalise_row(numerators.data(), sums.data(), squares.data(), terms,
                                best_actual.data(), gates_actual.data(), count());
    EXPECT_EQ(best_expected, best_actual) << target.name;
    EXPECT_EQ(gates_expected, gates_actual) << target.name;
  }
}

TEST_P(Kernels, AnyAboveFindsTheLastValue) {
  auto values = random_values<std::int32_t>(count(), -1000, 0);
  const std::vector<float> gates(count(), 10);
  for (const auto& target : targets()) {
    values.back() = 20;
    EXPECT_FALSE(target.table->any_above_row(values.data(), 0.5f, gates.data(), count()))
        << target.name;
    values.back() = 21;
    EXPECT_TRUE(target.table->any_above_row(values.data(), 0.5f, gates.data(), count()))
        << target.name;
  }
}

INSTANTIATE_TEST_SUITE_P(OddSizesAndMisalignments, Kernels, odd_sizes_and_misalignments());

}  // namespace
}  // namespace mbncc::kernels
