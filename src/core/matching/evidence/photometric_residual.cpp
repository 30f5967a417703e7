// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/photometric_residual.hpp"

#include <algorithm>
#include <cmath>

#include "simd/lanes.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kChannels = templates::SurfaceTemplate::kChannels;

/// Iteratively reweights points by their residuals until the variance converges. Returns the
/// variance [grey^2] of the weighted `residual`.
double weigh(const std::vector<float>& residual, const std::vector<float>& inside,
             std::vector<float>& weights) {
  constexpr int kPasses = 3;
  constexpr float kUsual = 4;         // variances that halve the weight
  constexpr double kQuantised = .05;  // [grey^2] of the least noise
  thread_local std::vector<float> squares;
  squares.resize(residual.size());
  for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = residual[i] * residual[i];
  double variance = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto [total, sum] = kernels::products<2>({weights.data(), weights.data()},
                                                   {inside.data(), squares.data()}, squares.size());
    variance = sum / std::max(1e-6f, total) + kQuantised;
    const float scale = 1 / (kUsual * static_cast<float>(variance));
    for (std::size_t i = 0; i < squares.size(); ++i)
      weights[i] = inside[i] / (1 + scale * squares[i]);
  }
  return variance;
}

}  // namespace

/// Shading multiplies a colour, except for the camera's offset.
PhotometricResidual::PhotometricResidual(const templates::SurfaceTemplate& surface)
    : count_(surface.basis.size() + 1), points_(static_cast<double>(surface.size())) {
  constexpr double kAdded = 30;  // [grey]
  for (auto& part : direction_) part.assign(surface.padded(), 0.f);
  for (int k = 0; k < surface.basis.size(); ++k)
    terms_.insert(terms_.end(), surface.basis.row(k), surface.basis.row(k) + padded());
  terms_.resize(terms_.size() + padded(), 0.f);
  float* const learned = terms_.data() + terms_.size() - padded();
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const cv::Vec3d colour(surface.planes[0][i], surface.planes[1][i], surface.planes[2][i]);
    const cv::Vec3d direction = cv::normalize(colour + cv::Vec3d::all(kAdded));
    for (int c = 0; c < kChannels; ++c) direction_[c][i] = static_cast<float>(direction[c]);
    learned[i] = static_cast<float>(colour.dot(direction));
  }
}

double PhotometricResidual::misfit(const templates::SurfaceSample& sample) const {
  constexpr int kFits = 3;
  if (count_ == 0 || !sample.suffices()) return 0;
  thread_local std::vector<float> seen, weights, residual;
  read_brightness(sample, seen);
  weights = sample.inside;
  double variance = 0;
  for (int fit = 0; fit < kFits; ++fit) {
    residual = seen;
    subtract(light(seen, weights), residual);
    variance = weigh(residual, sample.inside, weights);
  }
  return std::log(variance + 1) / 2;
}

void PhotometricResidual::read_brightness(const templates::SurfaceSample& sample,
                                          std::vector<float>& seen) const {
  seen.resize(padded());
  const auto& d = direction_;
  const auto& p = sample.planes;
  for (std::size_t i = 0; i < padded(); ++i)
    seen[i] = d[0][i] * p[0][i] + d[1][i] * p[1][i] + d[2][i] * p[2][i];
}

/// Least squares, the gain near 1 where the template is plain.
PhotometricResidual::Light PhotometricResidual::light(const std::vector<float>& seen,
                                                      const std::vector<float>& weights) const {
  constexpr double kGainPrior = 60, kLeast = 1e-3;  // [grey^2] per point; of rows of unit length
  auto products = cv::Matx<double, kTerms, kTerms>::eye();
  Light right;
  thread_local std::vector<float> weighted;
  weighted.resize(padded());
  for (int k = 0; k < count_; ++k) {
    float sums[kTerms];
    for (std::size_t i = 0; i < padded(); ++i) weighted[i] = weights[i] * term(k)[i];
    kernels::dots(term(k), padded(), count_ - k, weighted.data(), static_cast<int>(padded()), sums);
    for (int j = k; j < count_; ++j) products(k, j) = products(j, k) = sums[j - k];
    products(k, k) += kLeast;
    right[k] = kernels::product(seen, weighted.data());
  }
  products(count_ - 1, count_ - 1) += kGainPrior * points_;
  right[count_ - 1] += kGainPrior * points_;
  return products.solve(right, cv::DECOMP_CHOLESKY);
}

void PhotometricResidual::subtract(const Light& light, std::vector<float>& values) const {
  for (int k = 0; k < count_; ++k) kernels::subtract(values, light[k], term(k));
}

}  // namespace mbncc::evidence
