// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/clutter_penalty.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>

namespace mbncc::decision {
namespace {

// Fitted together with the weights of the evidence model.
constexpr std::size_t kPlaces = 3;  // number of places used
constexpr double kWeight = 0.85;
constexpr double kMinOdds = -6, kMaxOdds = 5;  // log-odds: bounds of a place's contribution
constexpr double kInstance = 8;  // log-odds above which a place is an instance, not clutter

/// Contribution of a place of log-odds `odds` to the clutter; less if it is probably another
/// instance.
double clutter_weight(double odds) {
  const double uncertainty = std::clamp((kInstance - odds) / (kInstance - kMaxOdds), 0., 1.);
  return uncertainty * (std::clamp(odds, kMinOdds, kMaxOdds) - kMinOdds);
}

}  // namespace

double clutter_penalty(const std::vector<double>& odds) {
  if (odds.empty()) return 0;
  std::vector<double> contributions;
  std::transform(odds.begin() + 1, odds.end(), std::back_inserter(contributions), clutter_weight);
  std::sort(contributions.begin(), contributions.end(), std::greater<>());
  contributions.resize(kPlaces, 0);
  return kWeight * std::accumulate(contributions.begin(), contributions.end(), 0.) / kPlaces;
}

}  // namespace mbncc::decision
