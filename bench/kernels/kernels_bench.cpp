// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops: reference against vectorised version, at the sizes of a VGA search.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "simd/kernels.hpp"

namespace mbncc::bench {
namespace {

constexpr int kStride = 160;  // a row of a 640 x 480 image at a quarter of the resolution
constexpr int kRows = 120;
constexpr int kCount = 2 * kernels::kPositions;  // positions of a row that are processed together

template <class Number>
std::vector<Number> numbers(std::size_t count, int low, int high) {
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> draw(low, high);
  std::vector<Number> result(count);
  for (auto& number : result) number = static_cast<Number>(draw(generator));
  return result;
}

/// Offsets of a square template of `terms` pixels in an image of kStride columns.
std::vector<std::int32_t> square_offsets(int terms) {
  int side = 1;
  while (side * side < terms) ++side;
  std::vector<std::int32_t> offsets;
  for (int i = 0; i < terms; ++i) offsets.push_back(i / side * kStride + i % side);
  return offsets;
}

void correlate(benchmark::State& state, const kernels::Table& table) {
  const int pairs = static_cast<int>(state.range(0)), count = kCount;
  const auto image =
      numbers<std::int16_t>(kStride * kRows, -kernels::kMaxImage, kernels::kMaxImage);
  const auto weights = numbers<std::int16_t>(2 * static_cast<std::size_t>(pairs),
                                             -kernels::kMaxWeight, kernels::kMaxWeight);
  const auto offsets = square_offsets(pairs);
  std::vector<std::int32_t> sums(static_cast<std::size_t>(count));
  for (auto _ : state) {
    table.correlate_row(image.data(), offsets.data(), weights.data(), pairs, sums.data(), count);
    benchmark::DoNotOptimize(sums.data());
  }
  state.SetItemsProcessed(state.iterations() * 2 * pairs * count);  // multiply-adds
}

void best_responses(benchmark::State& state, const kernels::Table& table) {
  constexpr int kRotations = 4, kPositions = 3 * kernels::kPositions;
  constexpr int kBlock = kPositions * kernels::kResponseRows;
  const int terms = static_cast<int>(state.range(0));
  const auto maps =
      numbers<std::int8_t>(kStride * kRows, -kernels::kMaxResponse, kernels::kMaxResponse);
  const auto offsets = numbers<std::int32_t>(static_cast<std::size_t>(kRotations) * terms, 0,
                                             kStride * (kRows - kernels::kResponseRows - 1));
  const auto labels = numbers<std::int16_t>(kRotations, 0, 99);
  std::vector<std::int16_t> best(kBlock), labelled = best;
  for (auto _ : state) {
    table.best_responses_rows(maps.data(), kStride,
                              {offsets.data(), terms, labels.data(), kRotations}, best.data(),
                              labelled.data(), kPositions, kPositions);
    benchmark::DoNotOptimize(best.data());
  }
  state.SetItemsProcessed(state.iterations() * kRotations * terms * kBlock);  // additions
}

void sum_runs(benchmark::State& state, const kernels::Table& table) {
  const int runs = static_cast<int>(state.range(0)), count = kCount;
  const auto prefix = numbers<std::int32_t>(kStride * kRows, 0, 1 << 20);
  std::vector<std::int32_t> begins, ends, sums(static_cast<std::size_t>(count));
  for (int run = 0; run < runs; ++run) {
    begins.push_back(run * kStride);
    ends.push_back(run * kStride + 20);
  }
  for (auto _ : state) {
    table.sum_runs_row(prefix.data(), begins.data(), ends.data(), runs, sums.data(), count);
    benchmark::DoNotOptimize(sums.data());
  }
  state.SetItemsProcessed(state.iterations() * runs * count);
}

void strongest_of_three(benchmark::State& state, const kernels::Table& table) {
  const int count = static_cast<int>(state.range(0));
  const auto along_x = numbers<std::int16_t>(3 * static_cast<std::size_t>(count), -1024, 1024);
  const auto along_y = along_x;
  std::vector<std::int16_t> out(2 * static_cast<std::size_t>(count));
  for (auto _ : state) {
    table.strongest_of_three_row(along_x.data(), along_y.data(), out.data(), count);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * count);
}

void edge_vectors(benchmark::State& state, const kernels::Table& table) {
  const int count = static_cast<int>(state.range(0));
  const auto gradients = numbers<std::int16_t>(2 * static_cast<std::size_t>(count), -1024, 1024);
  const auto colours = numbers<std::uint8_t>(3 * static_cast<std::size_t>(count), 0, 255);
  std::vector<std::int8_t> edges(2 * static_cast<std::size_t>(count));
  for (auto _ : state) {
    table.edge_vectors_row(gradients.data(), colours.data(), edges.data(), count);
    benchmark::DoNotOptimize(edges.data());
  }
  state.SetItemsProcessed(state.iterations() * count);
}

using KernelBenchmark = void (*)(benchmark::State&, const kernels::Table&);

/// Registers one benchmark per target of this machine and per size.
bool register_all(const std::string& name, KernelBenchmark run, const std::vector<int>& sizes) {
  for (const auto& target : kernels::targets())
    for (const int size : sizes)
      benchmark::RegisterBenchmark((name + "/" + target.name).c_str(), run, *target.table)
          ->Arg(size);
  return true;
}

const bool kRegistered = register_all("correlate", correlate, {32, 200}) &&
                         register_all("best_responses", best_responses, {64}) &&
                         register_all("sum_runs", sum_runs, {8, 40}) &&
                         register_all("strongest_of_three", strongest_of_three, {640}) &&
                         register_all("edge_vectors", edge_vectors, {640});

}  // namespace
}  // namespace mbncc::bench
