// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/trimmed_residual.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mbncc::evidence {
namespace {

constexpr int kChannels = templates::SurfaceTemplate::kChannels;
constexpr double kLeastPoints = 4;  // least number of points in a compared block

struct Gain {
  double factor, offset;
};

/// Sums over all channels of one or several blocks.
struct Sums {
  double count = 0, t = 0, s = 0, tt = 0, ts = 0, ss = 0;

  Sums() = default;
  explicit Sums(const templates::BlockSums& block) : count(kChannels * block.count) {
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

  /// Gain within bounds and offset that fit the template's colours to the image's.
  Gain gain() const {
    constexpr double kPrior = 100;  // [grey^2] pulls the gain of plain surfaces to 1
    constexpr double kLeast = 0.65, kMost = 1.5;
    const double variance = tt / count - t / count * (t / count);
    const double covariance = ts / count - t / count * (s / count);
    const double factor = std::clamp((covariance + kPrior) / (variance + kPrior), kLeast, kMost);
    return {factor, (s - factor * t) / count};
  }

  /// Mean square [grey^2] of the residual after this gain.
  double square(const Gain& gain) const {
    const double a = gain.factor, b = gain.offset;
    return (ss + a * a * tt - 2 * (a * ts + b * s - a * b * t)) / count + b * b;
  }
};

/// Sum of the five eighths of `parts` with the smallest residuals after `gain`.
Sums best_explained(const std::vector<Sums>& parts, const Gain& gain) {
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t i = 0; i < parts.size(); ++i) sorted.emplace_back(parts[i].square(gain), i);
  const std::size_t kept = (parts.size() * 5 + 7) / 8;
  std::nth_element(sorted.begin(), sorted.begin() + kept - 1, sorted.end());
  Sums sum;
  for (std::size_t k = 0; k < kept; ++k) sum += parts[sorted[k].second];
  return sum;
}

}  // namespace

double trimmed_residual(const std::vector<templates::BlockSums>& blocks) {
  constexpr int kSteps = 2;
  std::vector<Sums> parts;
  Sums kept;
  for (const auto& block : blocks)
    if (block.count >= kLeastPoints) kept += parts.emplace_back(block);
  if (parts.empty()) return -1;
  for (int step = 0; step < kSteps; ++step) kept = best_explained(parts, kept.gain());
  return std::sqrt(std::max(0.0, kept.square(kept.gain())));
}

}  // namespace mbncc::evidence
