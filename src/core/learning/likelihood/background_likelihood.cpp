// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/background_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "learning/likelihood/cast_shadow.hpp"
#include "learning/likelihood/faint_change.hpp"
#include "learning/likelihood/gradual_light.hpp"
#include "learning/likelihood/normalized_difference.hpp"
#include "learning/likelihood/texture_loss.hpp"

namespace mbncc::likelihood {
namespace {

constexpr float kStudentFreedom = 30;       // degrees of freedom of Student's distribution
constexpr float kShadowWeight = 0.12F;      // prior of a pixel in a shadow
constexpr float kOutlierWeight = 0.03F;     // prior of an arbitrary colour (glints, dust)
constexpr float kPlatformWeight = 0.0001F;  // prior of another platform colour (something shifted)
constexpr float kShadowScale = 0.25F;       // log-prior: small changes of light are more likely
constexpr float kShadowTint = 0.1F;         // deviation of one channel, per light taken away
constexpr float kShadowSlope = 0.1F;     // common deviation of all channels, per light taken away
constexpr float kShadowNoise = 1.2F;     // variance of a shadowed pixel, relative
constexpr int kShadowBox = 7;            // [px] a shadow's depth is averaged over this square
constexpr float kTextureLost = 6;        // largest log-odds of covered texture against a shadow
constexpr float kTextureKept = 4;        // largest log-odds of visible texture for a shadow
constexpr float kFaintlyChanged = 0.9F;  // probability of change found only in windows
constexpr float kLight = 5;              // log-odds of platform added for gradual light and shadows
constexpr float kHighestRatio = 60;      // largest log-likelihood ratio
constexpr float kHardlyPossible = 20;    // log-prior against light beyond its plausible range

// Light that a shadow leaves: least-squares factor from `after` to `before` in a small square.
cv::Mat remaining_light(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat both(before.size(), CV_32FC1), squares(before.size(), CV_32FC1);
  for (int y = 0; y < before.rows; ++y) {
    const auto* b = before.ptr<cv::Vec3f>(y);
    const auto* a = after.ptr<cv::Vec3f>(y);
    auto* product = both.ptr<float>(y);
    auto* square = squares.ptr<float>(y);
    for (int x = 0; x < before.cols; ++x) {
      product[x] = a[x].dot(b[x]);
      square[x] = a[x].dot(a[x]);
    }
  }
  cv::boxFilter(both, both, -1, {kShadowBox, kShadowBox});
  cv::boxFilter(squares, squares, -1, {kShadowBox, kShadowBox});
  cv::Mat light;
  cv::divide(both + 1, squares + 1, light);
  return light;
}

// Limits the light to the range that a shadow in either image may leave.
cv::Mat plausible(const cv::Mat& light, float darkest) {
  return cv::max(cv::min(light, 1 / darkest), darkest);
}

bool is_plausible(float light, float darkest) {
  return light >= darkest && light * darkest <= 1;
}

// Fit of a Gaussian around a predicted image.
struct Fit {
  cv::Mat distance;     // CV_32FC1, squared Mahalanobis
  cv::Mat determinant;  // CV_32FC1, of the covariance
};

Fit fit_unchanged(const cv::Mat& before, const cv::Mat& after, const cv::Mat& variance,
                  const cv::Matx33f& correlation) {
  Fit fit{normalized_difference(before, after, variance, correlation),
          cv::Mat(before.size(), CV_32FC1)};
  const auto determinant = static_cast<float>(cv::determinant(correlation));
  for (int y = 0; y < before.rows; ++y) {
    const auto* v = variance.ptr<cv::Vec3f>(y);
    auto* out = fit.determinant.ptr<float>(y);
    for (int x = 0; x < before.cols; ++x) out[x] = v[x][0] * v[x][1] * v[x][2] * determinant;
  }
  return fit;
}

// Symmetric 3 x 3 matrix, stored as its upper triangle.
struct Covariance {
  float c00, c01, c02, c11, c12, c22;

  // Sets the determinant and returns the squared Mahalanobis distance of `e`.
  float distance(const cv::Vec3f& e, float& determinant) const {
    const float a00 = c11 * c22 - c12 * c12, a01 = c02 * c12 - c01 * c22,
                a02 = c01 * c12 - c02 * c11, a11 = c00 * c22 - c02 * c02,
                a12 = c01 * c02 - c00 * c12, a22 = c00 * c11 - c01 * c01;
    determinant = c00 * a00 + c01 * a01 + c02 * a02;
    return (e[0] * e[0] * a00 + e[1] * e[1] * a11 + e[2] * e[2] * a22 +
            2 * (e[0] * e[1] * a01 + e[0] * e[2] * a02 + e[1] * e[2] * a12)) /
           determinant;
  }
};

// Covariance of a shadowed pixel: noise, a shadow depth that varies within the box, and a tint.
Covariance shadow_covariance(const cv::Vec3f& after, const cv::Vec3f& variance, float light,
                             const cv::Matx33f& correlation) {
  const float lost = 1 - light;
  const cv::Vec3f noise(std::sqrt(kShadowNoise * variance[0]),
                        std::sqrt(kShadowNoise * variance[1]),
                        std::sqrt(kShadowNoise * variance[2]));
  const cv::Vec3f slope = kShadowSlope * lost * after, tint = kShadowTint * lost * after;
  const auto entry = [&](int i, int j) {
    return correlation(i, j) * noise[i] * noise[j] + slope[i] * slope[j];
  };
  return {entry(0, 0) + tint[0] * tint[0], entry(0, 1), entry(0, 2),
          entry(1, 1) + tint[1] * tint[1], entry(1, 2), entry(2, 2) + tint[2] * tint[2]};
}

Fit fit_shadow(const cv::Mat& before, const cv::Mat& after, const cv::Mat& light,
               const cv::Mat& variance, const cv::Matx33f& correlation) {
  Fit fit{cv::Mat(before.size(), CV_32FC1), cv::Mat(before.size(), CV_32FC1)};
  for (int y = 0; y < before.rows; ++y) {
    const auto* b = before.ptr<cv::Vec3f>(y);
    const auto* a = after.ptr<cv::Vec3f>(y);
    const auto* v = variance.ptr<cv::Vec3f>(y);
    const auto* k = light.ptr<float>(y);
    auto* distance = fit.distance.ptr<float>(y);
    auto* determinant = fit.determinant.ptr<float>(y);
    for (int x = 0; x < before.cols; ++x)
      distance[x] = shadow_covariance(a[x], v[x], k[x], correlation)
                        .distance(b[x] - k[x] * a[x], determinant[x]);
  }
  return fit;
}

// Log-density of Student's distribution, relative to uniform.
cv::Mat log_student(Fit& fit, float tail) {
  constexpr float kLogConstant = 2.7568F;  // 1.5 log(2 pi)
  const float constant = -kLogConstant - log_uniform_colour() - 1.5F * std::log(tail);
  pool(fit.distance);
  cv::Mat tails, determinant;
  cv::log(1 + fit.distance / (tail * kStudentFreedom), tails);
  cv::log(fit.determinant, determinant);
  return constant - 0.5F * determinant - 0.5F * (kStudentFreedom + 3) * tails;
}

// Log-prior of a shadow: faint shadows are more likely, and a shadow leaves the platform's texture
// visible.
cv::Mat log_shadow_prior(const cv::Mat& light, float darkest, const cv::Mat& lost) {
  cv::Mat prior(light.size(), CV_32FC1);
  for (int y = 0; y < light.rows; ++y) {
    const auto* k = light.ptr<float>(y);
    const auto* loss = lost.ptr<float>(y);
    auto* out = prior.ptr<float>(y);
    for (int x = 0; x < light.cols; ++x)
      out[x] = -std::abs(k[x] - 1) / kShadowScale -
               (is_plausible(k[x], darkest) ? 0 : kHardlyPossible) -
               std::clamp(loss[x], -kTextureKept, kTextureLost);
  }
  return prior;
}

cv::Mat exponential(const cv::Mat& logarithm) {
  cv::Mat values;
  cv::exp(cv::min(logarithm, kHighestRatio), values);
  return values;
}

// Adds log-odds of platform where `mask` is set.
void favour_platform(const cv::Mat& mask, float log_odds, BackgroundLikelihood& likelihood) {
  cv::add(likelihood.log_ratio, log_odds, likelihood.log_ratio, mask);
  const cv::Mat odds = likelihood.changed / (1 - likelihood.changed) * std::exp(-log_odds);
  cv::Mat(odds / (1 + odds)).copyTo(likelihood.changed, mask);
}

}  // namespace

float log_uniform_colour() {
  static const float value = -3 * std::log(256.F);
  return value;
}

BackgroundLikelihood background_likelihood(const cv::Mat& before, const cv::Mat& after,
                                           const NoiseModel& noise,
                                           const change::ColourMixture& platform,
                                           float darkest_shadow) {
  const cv::Mat variance = noise.variance_image(after), light = remaining_light(before, after);
  const cv::Mat lost = texture_loss(before, after, plausible(light, darkest_shadow), variance);
  Fit unchanged = fit_unchanged(before, after, variance, noise.correlation);
  Fit shaded = fit_shadow(before, after, light, variance, noise.correlation);
  // Copied before log_student() pools the distances.
  const Misfit misfit{unchanged.distance.clone(), shaded.distance.clone()};
  const cv::Mat plain = exponential(log_student(unchanged, noise.tail) +
                                    std::log(1 - kOutlierWeight - kShadowWeight));
  const cv::Mat shadow =
      exponential(log_student(shaded, noise.tail) + log_shadow_prior(light, darkest_shadow, lost) +
                  std::log(kShadowWeight));
  const cv::Mat elsewhere = platform.densities(before) * std::exp(-log_uniform_colour());
  const cv::Mat sum = plain + shadow + kPlatformWeight * elsewhere + kOutlierWeight;
  BackgroundLikelihood result;
  cv::log(sum, result.log_ratio);
  result.log_ratio = cv::min(result.log_ratio, kHighestRatio);
  result.changed = 1 / (1 + sum / 2);
  const cv::Mat faint = faint_change(misfit, after, variance, noise.tail, result.changed > 0.5);
  result.changed.setTo(kFaintlyChanged, faint & (result.changed < kFaintlyChanged));
  favour_platform(gradual_light(before, after, result.changed, lost, noise.sigma(1)), kLight,
                  result);
  favour_platform(cast_shadow(before, after), kLight, result);
  return result;
}

}  // namespace mbncc::likelihood
