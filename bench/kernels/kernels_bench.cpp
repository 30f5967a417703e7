// The innermost loops, formula against vectorised loop, at sizes that a VGA search has.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "polar/kernels.hpp"

namespace mbncc::bench {
namespace {

constexpr int kStride = 160;  // a row of a 640 x 480 picture at a quarter of the resolution
constexpr int kRows = 120;

template <class Number>
std::vector<Number> numbers(std::size_t count, int low, int high) {
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> draw(low, high);
  std::vector<Number> result(count);
  for (auto& number : result) number = static_cast<Number>(draw(generator));
  return result;
}

/// Offsets of a square template of `terms` pixels in a picture of kStride columns.
std::vector<std::int32_t> square_offsets(int terms) {
  int side = 1;
  while (side * side < terms) ++side;
  std::vector<std::int32_t> offsets;
  for (int i = 0; i < terms; ++i) offsets.push_back(i / side * kStride + i % side);
  return offsets;
}

void correlate(benchmark::State& state, const kernels::Table& table) {
  const int terms = static_cast<int>(state.range(0)), count = kStride / 2;
  const auto picture =
      numbers<std::int16_t>(kStride * kRows, -kernels::kMaxPicture, kernels::kMaxPicture);
  const auto weights = numbers<std::int16_t>(static_cast<std::size_t>(terms), -kernels::kMaxWeight,
                                             kernels::kMaxWeight);
  const auto offsets = square_offsets(terms);
  std::vector<std::int32_t> sums(static_cast<std::size_t>(count));
  for (auto _ : state) {
    table.correlate_row(picture.data(), offsets.data(), weights.data(), terms, sums.data(), count);
    benchmark::DoNotOptimize(sums.data());
  }
  state.SetItemsProcessed(state.iterations() * terms * count);  // multiply-adds
}

void sum_runs(benchmark::State& state, const kernels::Table& table) {
  const int runs = static_cast<int>(state.range(0)), count = kStride / 2;
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
  std::vector<std::int8_t> edges(2 * static_cast<std::size_t>(count));
  for (auto _ : state) {
    table.edge_vectors_row(gradients.data(), edges.data(), count);
    benchmark::DoNotOptimize(edges.data());
  }
  state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK_CAPTURE(correlate, reference, kernels::reference())->Arg(64)->Arg(400);
BENCHMARK_CAPTURE(correlate, vectorised, kernels::vectorised())->Arg(64)->Arg(400);
BENCHMARK_CAPTURE(sum_runs, reference, kernels::reference())->Arg(8)->Arg(40);
BENCHMARK_CAPTURE(sum_runs, vectorised, kernels::vectorised())->Arg(8)->Arg(40);
BENCHMARK_CAPTURE(strongest_of_three, reference, kernels::reference())->Arg(640);
BENCHMARK_CAPTURE(strongest_of_three, vectorised, kernels::vectorised())->Arg(640);
BENCHMARK_CAPTURE(edge_vectors, reference, kernels::reference())->Arg(640);
BENCHMARK_CAPTURE(edge_vectors, vectorised, kernels::vectorised())->Arg(640);

}  // namespace
}  // namespace mbncc::bench
