// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>
#include <vector>

#include "simd/kernels_fixture.hpp"

namespace mbncc::kernels {
namespace {

/// Largest sums at `count` positions of each row and the labels of their rotations.
std::pair<std::vector<std::int16_t>, std::vector<std::int16_t>> best_responses_of(
    const Table& table, const std::int8_t* maps, int stride, const ResponseTerms& terms,
    int count = kPositions) {
  const int step = count + 3;
  std::vector<std::int16_t> best(kResponseRows * step, -9), labels = best;
  table.best_responses_rows(maps, stride, terms, best.data(), labels.data(), step, count);
  return {best, labels};
}

TEST_P(Kernels, BestResponsesEqualReference) {
  constexpr int kReach = 50, kRotations = 5;
  const int stride = count(), positions = 3 * kPositions;
  const auto maps = random_values<std::int8_t>(
      kResponseRows * stride + positions + kReach + misalignment(), -kMaxResponse, kMaxResponse);
  const std::vector<std::int16_t> labels{3, 4, 7, 100, 32000};
  for (const int terms : {1, 8, 13, 64})
    for (const int parts : {1, 2, 4}) {
      const auto offsets = random_values<std::int32_t>(kRotations * terms, 0, kReach - 1);
      const auto run = [&](const Table& table) {
        return best_responses_of(table, maps.data() + misalignment(), stride,
                                 {offsets.data(), terms, labels.data(), kRotations, parts},
                                 positions);
      };
      for (const auto& target : targets())
        EXPECT_EQ(run(*target.table), run(reference()))
            << target.name << ", " << terms << " terms in " << parts << " parts";
    }
}

TEST(BestResponses, OmitTheWeakestPart) {
  std::vector<std::int8_t> maps(kResponseRows * kPositions + 4);
  const std::vector<std::int8_t> first{5, -7, 3, 4};
  std::copy(first.begin(), first.end(), maps.begin());
  const std::vector<std::int32_t> offsets{0, 1, 2, 3};
  const std::vector<std::int16_t> labels{1};
  const auto best_with = [&](int parts, const Table& table) {
    return best_responses_of(table, maps.data(), kPositions,
                             {offsets.data(), 4, labels.data(), 1, parts})
        .first.front();
  };
  for (const auto& target : targets()) {
    EXPECT_EQ(best_with(1, *target.table), 5 - 7 + 3 + 4) << target.name;
    EXPECT_EQ(best_with(2, *target.table), 3 + 4) << target.name;
    EXPECT_EQ(best_with(4, *target.table), 5 + 3 + 4) << target.name;
  }
}

/// Uses maps with one value, and `terms` terms per rotation.
void expect_best_response(std::int8_t value, int terms, const std::vector<std::int16_t>& labels,
                          int best, int label) {
  const std::vector<std::int8_t> maps(kResponseRows * kPositions, value);
  const std::vector<std::int32_t> offsets(terms * labels.size(), 0);
  for (const auto& target : targets()) {
    const auto found =
        best_responses_of(*target.table, maps.data(), kPositions,
                          {offsets.data(), terms, labels.data(), static_cast<int>(labels.size())});
    EXPECT_EQ(found.first.front(), best) << target.name;
    EXPECT_EQ(found.second.front(), label) << target.name;
  }
}

TEST(BestResponses, AreThoseOfTheFirstOfEqualRotations) {
  expect_best_response(1, 1, {5, 6, 7}, 1, 5);
}

TEST(BestResponses, AreNotNegative) {
  expect_best_response(-1, 1, {5}, 0, 0);
}

TEST(BestResponses, DoNotOverflowAtTheirBounds) {
  constexpr int kTerms = 2000;
  expect_best_response(kMaxResponse, kTerms, {3}, kTerms * kMaxResponse, 3);
}

TEST_P(Kernels, EdgeResponsesEqualReference) {
  const auto edges = random_values<std::int8_t>(2 * count() + misalignment(), -127, 127);
  const auto run = [&](const Table& table) {
    std::vector<std::vector<std::int8_t>> responses(4, std::vector<std::int8_t>(count()));
    std::int8_t* rows[4];
    for (int k = 0; k < 4; ++k) rows[k] = responses[k].data();
    table.edge_responses_row(edges.data() + misalignment(), rows, count());
    return responses;
  };
  for (const auto& target : targets())
    EXPECT_EQ(run(*target.table), run(reference())) << target.name;
}

TEST(EdgeResponses, StayWithinTheirBoundForAllEdgeVectors) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const std::int8_t edge[] = {
        static_cast<std::int8_t>(std::lround(127 * std::cos(degrees * 0.0174532925))),
        static_cast<std::int8_t>(std::lround(127 * std::sin(degrees * 0.0174532925)))};
    std::int8_t responses[4];
    std::int8_t* rows[] = {responses, responses + 1, responses + 2, responses + 3};
    reference().edge_responses_row(edge, rows, 1);
    for (int k = 0; k < 4; ++k) {
      EXPECT_LE(std::abs(responses[k]), kMaxResponse);
      EXPECT_NEAR(responses[k], kMaxResponse * std::cos((degrees - 45 * k) * 0.0174532925), 0.7);
    }
  }
}

TEST_P(Kernels, SpreadRowsEqualsReference) {
  const auto image = random_values<std::int8_t>(3 * (2 * count() + 3) + misalignment(), -15, 15);
  const std::int8_t* rows[3];
  for (int k = 0; k < 3; ++k) rows[k] = image.data() + misalignment() + k * (2 * count() + 3) + 1;
  const auto run = [&](const Table& table) {
    std::vector<std::int8_t> even(count()), odd(count());
    table.spread_rows_row(rows, even.data(), odd.data(), count());
    return std::make_pair(even, odd);
  };
  for (const auto& target : targets())
    EXPECT_EQ(run(*target.table), run(reference())) << target.name;
}

TEST_P(Kernels, SmoothingEqualsReference) {
  constexpr int kWeights[] = {114, 61, 10};
  const int width = count() + 12;
  const auto image = random_values<std::uint8_t>(5 * width + misalignment(), 0, 255);
  const std::uint8_t* rows[5];
  for (int k = 0; k < 5; ++k) rows[k] = image.data() + misalignment() + k * width;
  const auto run = [&](const Table& table) {
    std::vector<std::uint16_t> sums(width);
    std::vector<std::uint8_t> smooth(count());
    table.smooth_columns_row(rows, kWeights, sums.data(), width);
    table.smooth_along_row_row(sums.data() + 6, kWeights, smooth.data(), count());
    return std::make_pair(sums, smooth);
  };
  for (const auto& target : targets())
    EXPECT_EQ(run(*target.table), run(reference())) << target.name;
}

TEST_P(Kernels, SmoothingKeepsWhite) {
  constexpr int kWeights[] = {170, 42, 1};
  const std::vector<std::uint8_t> white(count() + 12, 255);
  const std::uint8_t* rows[] = {white.data(), white.data(), white.data(), white.data(),
                                white.data()};
  for (const auto& target : targets()) {
    std::vector<std::uint16_t> sums(white.size());
    std::vector<std::uint8_t> smooth(count());
    target.table->smooth_columns_row(rows, kWeights, sums.data(), static_cast<int>(white.size()));
    target.table->smooth_along_row_row(sums.data() + 6, kWeights, smooth.data(), count());
    EXPECT_EQ(smooth, std::vector<std::uint8_t>(count(), 255)) << target.name;
  }
}

TEST_P(Kernels, SlopesEqualReference) {
  const int width = count() + 6;
  const auto image = random_values<std::uint8_t>(3 * width + misalignment(), 0, 255);
  const std::uint8_t* rows[3];
  for (int k = 0; k < 3; ++k) rows[k] = image.data() + misalignment() + k * width + 3;
  const auto run = [&](const Table& table) {
    std::vector<std::int16_t> along_x(count()), along_y(count());
    table.slopes_row(rows, along_x.data(), along_y.data(), count());
    return std::make_pair(along_x, along_y);
  };
  for (const auto& target : targets())
    EXPECT_EQ(run(*target.table), run(reference())) << target.name;
}

TEST_P(Kernels, StrongestOfThreeEqualsReference) {
  const auto x = random_values<std::int16_t>(3 * count() + misalignment(), -1024, 1024);
  const auto y = random_values<std::int16_t>(3 * count() + misalignment(), -1024, 1024);
  std::vector<std::int16_t> expected(2 * count()), actual(2 * count());
  reference().strongest_of_three_row(x.data() + misalignment(), y.data() + misalignment(),
                                     expected.data(), count());
  for (const auto& target : targets()) {
    target.table->strongest_of_three_row(x.data() + misalignment(), y.data() + misalignment(),
                                         actual.data(), count());
    EXPECT_EQ(expected, actual) << target.name;
  }
}

TEST_P(Kernels, EdgeVectorsEqualReference) {
  const auto gradients = random_values<std::int16_t>(2 * count() + misalignment(), -1024, 1024);
  const auto colours = random_values<std::uint8_t>(3 * count() + misalignment(), 0, 255);
  std::vector<std::int8_t> expected(2 * count()), actual(2 * count());
  reference().edge_vectors_row(gradients.data() + misalignment(), colours.data() + misalignment(),
                               expected.data(), count());
  for (const auto& target : targets()) {
    target.table->edge_vectors_row(gradients.data() + misalignment(),
                                   colours.data() + misalignment(), actual.data(), count());
    EXPECT_EQ(expected, actual) << target.name;
  }
}

INSTANTIATE_TEST_SUITE_P(OddSizesAndMisalignments, Kernels, odd_sizes_and_misalignments());

}  // namespace
}  // namespace mbncc::kernels
