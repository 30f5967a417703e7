// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/gain_offset.hpp"

#include <cstddef>

namespace mbncc::evidence {

// Iteratively reweighted least squares.
GainOffset fit_gain_offset(const std::array<std::vector<float>, 3>& learned,
                           const std::array<std::vector<float>, 3>& seen,
                           const std::vector<float>& weights) {
  constexpr int kChannels = 3;
  constexpr int kPasses = 4;
  constexpr double kPrior = 0.02;  // weight of an offset of 0: only glare and haze add to colours
  constexpr double kUsual = 400;   // [grey^2] mean square residual that halves a point's weight
  constexpr double kLeast = 0.15, kMost = 4;
  constexpr double kBlack = 1;  // [grey^2] weight of a factor of 1, for black surfaces
  GainOffset light;
  for (int pass = 0; pass < kPasses; ++pass) {
    double total = 0, t = 0, s = 0, tt = 0, ts = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] == 0) continue;
      double square = 0;
      for (int c = 0; c < kChannels && pass > 0; ++c) {
        const double off = seen[c][i] - light.factor * learned[c][i] - light.offset;
        square += off * off / kChannels;
      }
      const double weight = weights[i] / (1 + square / kUsual);
      for (int c = 0; c < kChannels; ++c) {
        total += weight;
        t += weight * learned[c][i];
        s += weight * seen[c][i];
        tt += weight * learned[c][i] * learned[c][i];
        ts += weight * learned[c][i] * seen[c][i];
      }
    }
    const double damped = (1 + kPrior) * total, black = kBlack * total;
    const double factor = (ts - t * s / damped + black) / (tt - t * t / damped + black);
    light.factor = std::clamp(factor, kLeast, kMost);
    light.offset = (s - light.factor * t) / damped;
  }
  return light;
}

GainOffset light_on(const templates::SurfaceTemplate& surface,
                    const templates::SurfaceSample& sample) {
  if (sample.visible == 0) return {};
  return fit_gain_offset(surface.planes, sample.planes, sample.inside);
}

}  // namespace mbncc::evidence
