// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/ratio_residual.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/order_statistics.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kChannels = templates::SurfaceTemplate::kChannels;
constexpr float kDark = 30;  // [grey levels] added, because noise dominates dark ratios

}  // namespace

RatioResidual::RatioResidual(const templates::SurfaceTemplate& surface, double area) {
  constexpr double kNear = 1.5;  // [side of a point's share of the area] largest distance of a pair
  const double square = kNear * kNear * area / static_cast<double>(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (std::size_t j = i + 1; j < surface.size(); ++j) {
      const double x = surface.x[i] - surface.x[j], y = surface.y[i] - surface.y[j];
      if (x * x + y * y <= square) pairs_.emplace_back(i, j);
    }
}

double RatioResidual::misfit(const templates::SurfaceTemplate& surface,
                             const templates::SurfaceSample& sample) const {
  constexpr float kPercent = 100, kNoise = 1;  // [%] noise of a camera
  if (pairs_.empty() || !sample.suffices()) return 0;
  double learned = 0, seen = 0;
  for (int c = 0; c < kChannels; ++c)
    for (std::size_t i = 0; i < surface.size(); ++i) {
      learned += sample.inside[i] * surface.planes[c][i];
      seen += sample.inside[i] * sample.planes[c][i];
    }
  const auto dark = static_cast<float>(kDark * std::max(seen, 1.0) / std::max(learned, 1.0));
  std::vector<float> differences, ratios(surface.size());
  for (int c = 0; c < kChannels; ++c) {
    for (std::size_t i = 0; i < ratios.size(); ++i)
      ratios[i] = std::log((sample.planes[c][i] + dark) / (surface.planes[c][i] + kDark));
    for (const auto& [i, j] : pairs_)
      if (sample.inside[i] > 0 && sample.inside[j] > 0)
        differences.push_back(kPercent * std::abs(ratios[i] - ratios[j]));
  }
  if (differences.empty()) return 0;
  return std::log(std::hypot(kNoise, numeric::median(differences)));
}

double rotation_odds(const Evidence& evidence, double misfit) {
  // Fitted by logistic regression to right and wrong rotations at the same place.
  return 68 * evidence.contour_score - 9 * evidence.log_residual - 12 * misfit;
}

}  // namespace mbncc::evidence
