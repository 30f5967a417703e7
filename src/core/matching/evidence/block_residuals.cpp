// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/block_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simd/point_kernels.hpp"

namespace mbncc {
namespace {

constexpr int kChannels = SurfaceTemplate::kChannels;
constexpr double kLeastPoints = 4;  // of a part that is compared

std::size_t five_of_eight(std::size_t count) {
  return (count * 5 + 7) / 8;
}

/// Sums over all channels of a part, or of several.
struct Sums {
  double count = 0, t = 0, s = 0, tt = 0, ts = 0, ss = 0;

  Sums() = default;
  explicit Sums(const BlockSums& block) : count(kChannels * block.count) {
    for (int c = 0; c < kChannels; ++c) {
      t += block.learned[c];
      s += block.seen[c];
      tt += block.learned_square[c];
      ts += block.product[c];
      ss += block.seen_square[c];
    }
  }

  Sums& operator+=(const Sums& other) {
    count += other.count;
    t += other.t;
    s += other.s;
    tt += other.tt;
    ts += other.ts;
    ss += other.ss;
    return *this;
  }

  /// Gain within bounds and offset that fit the template's colours to the picture's.
  kernels::Gain gain() const {
    constexpr double kPrior = 100;  // [grey^2] pulls the gain of plain surfaces to 1
    constexpr double kLeast = 0.65, kMost = 1.5;
    const double variance = tt / count - t / count * (t / count);
    const double covariance = ts / count - t / count * (s / count);
    const double factor = std::clamp((covariance + kPrior) / (variance + kPrior), kLeast, kMost);
    return {static_cast<float>(factor), static_cast<float>(s / count - factor * t / count)};
  }

  /// [grey^2] mean
  double square(const kernels::Gain& gain) const {
    const double a = gain.factor, b = gain.offset;
    return (ss + a * a * tt - 2 * (a * ts + b * s - a * b * t)) / count + b * b;
  }
};

/// The sums of the parts with the smallest residuals in a light.
Sums best_explained(const std::vector<Sums>& blocks, const kernels::Gain& gain) {
  std::vector<std::pair<double, const Sums*>> sorted;
  for (const auto& block : blocks) sorted.emplace_back(block.square(gain), &block);
  const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(five_of_eight(blocks.size()) - 1);
  std::nth_element(sorted.begin(), last, sorted.end());
  Sums kept;
  for (auto one = sorted.begin(); one <= last; ++one) kept += *one->second;
  return kept;
}

/// The best of three local fits, started from the light of all parts and of either half.
kernels::Gain trimmed_gain(const std::vector<BlockSums>& all) {
  constexpr int kSteps = 2;
  std::vector<Sums> blocks;
  for (const auto& one : all)
    if (one.count >= kLeastPoints) blocks.emplace_back(one);
  kernels::Gain best{1, 0};
  double least = std::numeric_limits<double>::infinity();
  const auto improve_from = [&](std::size_t begin, std::size_t end) {
    Sums kept;
    for (std::size_t i = begin; i < end; ++i) kept += blocks[i];
    for (int step = 0; step < kSteps; ++step) kept = best_explained(blocks, kept.gain());
    const kernels::Gain gain = kept.gain();
    if (kept.square(gain) >= least) return;
    least = kept.square(gain);
    best = gain;
  };
  const std::size_t half = blocks.size() / 2;
  if (!blocks.empty()) improve_from(0, blocks.size());
  if (half > 0) {
    improve_from(0, half);
    improve_from(half, blocks.size());
  }
  return best;
}

}  // namespace

std::vector<double> block_residuals(const SurfaceTemplate& surface, const SurfaceSample& sample,
                                    const std::vector<BlockSums>& blocks) {
  constexpr float kWorst = 60 * 60;  // [grey^2] of one value
  const kernels::Gain gain = trimmed_gain(blocks);
  thread_local std::vector<float> squares;
  squares.assign(surface.padded(), 0.f);
  for (int c = 0; c < kChannels; ++c)
    kernels::add_capped_squares(surface.planes[c].data(), sample.planes[c].data(),
                                sample.inside.data(), gain, kWorst,
                                static_cast<int>(surface.padded()), squares.data());
  std::vector<double> residuals;
  int begin = 0;
  for (const int end : surface.block_ends) {
    float total = 0, count = 0;
    for (int i = begin; i < end; ++i) {
      total += squares[i];
      count += sample.inside[i];
    }
    residuals.push_back(count >= kLeastPoints ? std::sqrt(total / (kChannels * count)) : -1);
    begin = end;
  }
  return residuals;
}

double best_of(const std::vector<double>& residuals) {
  std::vector<double> squares;
  for (const double residual : residuals)
    if (residual >= 0) squares.push_back(residual * residual);
  if (squares.empty()) return -1;
  std::sort(squares.begin(), squares.end());
  const std::size_t best = five_of_eight(squares.size());
  double total = 0;
  for (std::size_t i = 0; i < best; ++i) total += squares[i];
  return std::sqrt(total / static_cast<double>(best));
}

}  // namespace mbncc
