// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/mixed_pixel_equations.hpp"

#include <algorithm>
#include <numeric>

#include "simd/lanes.hpp"

namespace mbncc::refinement {
namespace {

constexpr int kLight = MixedPixelModel::kLight;

/// Prior information [per point] about a term of light.
double prior_of(int term) {
  constexpr double kGain = 400, kOffset = 5e-4, kShading = 0.02;
  return term == 0 ? kGain : term <= MixedPixelModel::kChannels ? kOffset : kShading;
}

std::vector<int> first_integers(int count) {
  std::vector<int> integers(count);
  std::iota(integers.begin(), integers.end(), 0);
  return integers;
}

}  // namespace

MixedPixelEquations::MixedPixelEquations(const MixedPixelModel& object)
    : object_(object), weights_(kAxes * padded(), 1.f), inside_(padded(), 0.f) {
  for (int axis = 0; axis < kAxes; ++axis) {
    rows_[axis].resize((terms(axis) + 1 + kMotion) * padded(), 0.f);
    std::copy(object.light[axis].begin(), object.light[axis].end(), rows_[axis].begin());
  }
}

void MixedPixelEquations::read(const MixedPixelSample& reading) {
  for (int axis = 0; axis < kAxes; ++axis)
    std::copy_n(&reading.values[axis * padded()], padded(), row(axis, terms(axis)));
  inside_ = reading.inside;
}

void MixedPixelEquations::set_slope(int motion, const MixedPixelSample& low,
                                    const MixedPixelSample& high) {
  for (int axis = 0; axis < kAxes; ++axis) {
    float* const slopes = row(axis, terms(axis) + 1 + motion);
    const float* const before = &low.values[axis * padded()];
    const float* const after = &high.values[axis * padded()];
    for (std::size_t i = 0; i < padded(); ++i)
      slopes[i] = low.inside[i] * high.inside[i] * (before[i] - after[i]);
  }
}

/// Weighted products of all rows: those of the light and the picture, and `more` others.
cv::Mat1d MixedPixelEquations::products(int rows_beside_light) const {
  thread_local std::vector<float> weighted;
  weighted.resize(padded());
  cv::Mat1d sums = cv::Mat1d::zeros(kUnknowns, kUnknowns);
  for (int axis = 0; axis < kAxes; ++axis) {
    std::vector<int> place = MixedPixelModel::terms_along(axis);
    for (int k = 0; k < rows_beside_light; ++k) place.push_back(kSeen + k);
    const float* const weights = &weights_[axis * padded()];
    const int count = static_cast<int>(place.size());
    for (int k = 0; k < count; ++k) {
      const float* const values = row(axis, k);
      for (std::size_t i = 0; i < padded(); ++i) weighted[i] = weights[i] * inside_[i] * values[i];
      float found[kUnknowns];
      kernels::dots(values, padded(), count - k, weighted.data(), static_cast<int>(padded()),
                    found);
      for (int j = k; j < count; ++j) sums(place[k], place[j]) += found[j - k];
    }
  }
  cv::completeSymm(sums);
  return sums;
}

/// Values of the `unknowns`, the first of which are the terms of light.
cv::Mat1d MixedPixelEquations::solved(const cv::Mat1d& products,
                                      const std::vector<int>& unknowns) const {
  const int count = static_cast<int>(unknowns.size());
  cv::Mat1d square(count, count), right(count, 1), found;
  for (int k = 0; k < count; ++k) {
    for (int j = 0; j < count; ++j) square(k, j) = products(unknowns[k], unknowns[j]);
    right(k) = products(unknowns[k], kSeen);
    if (k < kLight) square(k, k) += object_.size * prior_of(k);
  }
  right(0) += object_.size * prior_of(0);
  if (!cv::solve(square, right, found, cv::DECOMP_CHOLESKY)) found = cv::Mat1d::zeros(count, 1);
  return found;
}

MixedPixelEquations::Light MixedPixelEquations::light() const {
  static const std::vector<int> terms = first_integers(kLight);
  const cv::Mat1d found = solved(products(1), terms);
  Light light;
  std::copy(found.begin(), found.end(), light.begin());
  return light;
}

cv::Vec3d MixedPixelEquations::motion() const {
  static const std::vector<int> unknowns = [] {
    std::vector<int> chosen = first_integers(kUnknowns);
    chosen.erase(chosen.begin() + kSeen);
    return chosen;
  }();
  const cv::Mat1d found = solved(products(1 + kMotion), unknowns);
  return {found(kLight), found(kLight + 1), found(kLight + 2)};
}

void MixedPixelEquations::subtract(const Light& light, std::vector<float>& residual) const {
  residual.resize(kAxes * padded());
  for (int axis = 0; axis < kAxes; ++axis) {
    float* const left = &residual[axis * padded()];
    std::copy_n(row(axis, terms(axis)), padded(), left);
    for (int k = 0; k < terms(axis); ++k) {
      const auto factor = static_cast<float>(light[MixedPixelModel::terms_along(axis)[k]]);
      const float* const term = row(axis, k);
      for (std::size_t i = 0; i < padded(); ++i) left[i] -= factor * term[i];
    }
  }
}

}  // namespace mbncc::refinement
