#include "learning/background_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc {
namespace {

constexpr float kStudentFreedom = 30;      // tails of the unchanged term
constexpr float kShadowWeight = 0.15F;     // prior of a pixel lying in a shadow
constexpr float kOutlierWeight = 0.01F;    // prior of any colour at all (glints, dust)
constexpr float kPlatformWeight = 0.001F;  // prior of platform from elsewhere (something shifted)
constexpr float kDarkestShadow = 0.3F;     // of the light that is left
constexpr float kShadowScale = 0.25F;      // log-prior: a shadow is the likelier the lighter it is
constexpr float kBrightScale = 0.06F;      // likewise for the light that an object's flank throws
constexpr float kShadowTint = 0.1F;        // colour change of a shadow, part of what it takes away
constexpr float kShadowNoise = 1.2F;       // variance of a shadowed pixel, relative
constexpr int kShadowBox = 5;              // [px] a shadow's depth is averaged over this square
constexpr float kHighestRatio = 60;        // cap of the logarithms
constexpr float kHardlyPossible = 20;      // log-prior against shadows darker than the darkest

// Light that is left: least squares factor of before over after in a small square.
cv::Mat remaining_light(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat both(before.size(), CV_32FC1), squares(before.size(), CV_32FC1);
  for (int y = 0; y < before.rows; ++y) {
    const auto* b = before.ptr<cv::Vec3f>(y);
    const auto* a = after.ptr<cv::Vec3f>(y);
    for (int x = 0; x < before.cols; ++x) {
      both.at<float>(y, x) = a[x].dot(b[x]);
      squares.at<float>(y, x) = a[x].dot(a[x]);
    }
  }
  cv::boxFilter(both, both, -1, {kShadowBox, kShadowBox});
  cv::boxFilter(squares, squares, -1, {kShadowBox, kShadowBox});
  cv::Mat light;
  cv::divide(both + 1, squares + 1, light);
  return light;
}

// Picture and variance that a shadow of this depth would give.
void shadowed(const cv::Mat& after, const cv::Mat& light, const cv::Mat& variance,
              cv::Mat& predicted, cv::Mat& shadow_variance) {
  predicted.create(after.size(), CV_32FC3);
  shadow_variance.create(after.size(), CV_32FC3);
  for (int y = 0; y < after.rows; ++y) {
    const auto* a = after.ptr<float>(y);
    const auto* v = variance.ptr<float>(y);
    auto* p = predicted.ptr<float>(y);
    auto* w = shadow_variance.ptr<float>(y);
    for (int x = 0; x < after.cols; ++x) {
      const float k = light.at<float>(y, x);
      for (int i = 3 * x; i < 3 * x + 3; ++i) {
        const float tint = kShadowTint * a[i] * (1 - k);
        p[i] = k * a[i];
        w[i] = kShadowNoise * v[i] + tint * tint;
      }
    }
  }
}

// Log-density of Student's distribution about the platform's colour, relative to uniform.
float student(float difference, const float* variance, float tail) {
  constexpr float kLogConstant = 2.7568F;  // 1.5 log(2 pi)
  const float determinant = variance[0] * variance[1] * variance[2] * tail * tail * tail;
  return -0.5F * std::log(determinant) - kLogConstant - log_uniform_colour() -
         0.5F * (kStudentFreedom + 3) * std::log1p(difference / (tail * kStudentFreedom));
}

float shadow_prior(float light) {
  const float prior = light < 1 ? (light - 1) / kShadowScale : (1 - light) / kBrightScale;
  return light < kDarkestShadow ? prior - kHardlyPossible : prior;
}

}  // namespace

float log_uniform_colour() {
  static const float value = -3 * std::log(256.F);
  return value;
}

BackgroundLikelihood background_likelihood(const cv::Mat& before, const cv::Mat& after,
                                           const NoiseModel& noise, const ColourMixture& platform) {
  const cv::Mat variance = noise.variance_picture(after), light = remaining_light(before, after);
  cv::Mat shadow_picture, shadow_variance;
  shadowed(after, light, variance, shadow_picture, shadow_variance);
  cv::Mat unchanged = normalized_difference(before, after, variance);
  cv::Mat shaded = normalized_difference(before, shadow_picture, shadow_variance);
  pool(unchanged);
  pool(shaded);

  static const float log_unchanged = std::log(1 - kOutlierWeight - kShadowWeight);
  static const float log_shadow = std::log(kShadowWeight);
  const float uniform = std::exp(-log_uniform_colour());
  BackgroundLikelihood result;
  result.log_ratio.create(before.size(), CV_32FC1);
  result.changed.create(before.size(), CV_32FC1);
  for (int y = 0; y < before.rows; ++y)
    for (int x = 0; x < before.cols; ++x) {
      const float plain = student(unchanged.at<float>(y, x), variance.ptr<float>(y, x), noise.tail);
      const float shade =
          student(shaded.at<float>(y, x), shadow_variance.ptr<float>(y, x), noise.tail) +
          shadow_prior(light.at<float>(y, x));
      const float shadow = std::exp(std::min(kHighestRatio, shade + log_shadow));
      const float surface = std::exp(plain + log_unchanged) + shadow + kOutlierWeight;
      const float sum =
          surface + kPlatformWeight * uniform * platform.density(before.at<cv::Vec3f>(y, x));
      result.log_ratio.at<float>(y, x) = std::min(kHighestRatio, std::log(sum));
      result.changed.at<float>(y, x) = 1 / (1 + sum / 2);
    }
  return result;
}

}  // namespace mbncc
