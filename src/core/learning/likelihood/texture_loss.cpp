// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/texture_loss.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr int kFine = 7;            // [px] texture is the deviation from the mean over this square
constexpr int kWindow = 7;          // [px] texture is compared in this window
constexpr float kSamples = 14;      // effectively independent samples in such a window
constexpr float kTolerance = .02F;  // part of the texture's power that a shadow may change

// Powers of the texture, summed over the channels and averaged over the window.
struct TexturePower {
  cv::Mat before, after, common, noise;  // CV_32FC1
};

cv::Mat fine_texture(const cv::Mat& image) {
  cv::Mat mean;
  cv::blur(image, mean, {kFine, kFine});
  return image - mean;
}

TexturePower measure(const cv::Mat& before, const cv::Mat& after, const cv::Mat& variance) {
  const cv::Mat fine_before = fine_texture(before), fine_after = fine_texture(after);
  cv::Mat powers(before.size(), CV_32FC4);
  for (int y = 0; y < before.rows; ++y) {
    const auto* b = fine_before.ptr<cv::Vec3f>(y);
    const auto* a = fine_after.ptr<cv::Vec3f>(y);
    const auto* v = variance.ptr<cv::Vec3f>(y);
    auto* power = powers.ptr<cv::Vec4f>(y);
    for (int x = 0; x < before.cols; ++x)
      power[x] = {b[x].dot(b[x]), a[x].dot(a[x]), a[x].dot(b[x]), v[x][0] + v[x][1] + v[x][2]};
  }
  cv::blur(powers, powers, {kWindow, kWindow});
  TexturePower result;
  cv::Mat* const planes[] = {&result.before, &result.after, &result.common, &result.noise};
  for (int i = 0; i < 4; ++i) cv::extractChannel(powers, *planes[i], i);
  return result;
}

}  // namespace

// Both hypotheses are normal distributions of the residual power: if covered, all texture before
// belongs to the object; if visible, only the part that the dimmed texture does not explain.
cv::Mat texture_loss(const cv::Mat& before, const cv::Mat& after, const cv::Mat& light,
                     const cv::Mat& variance) {
  const TexturePower power = measure(before, after, variance);
  const cv::Mat dimmed = power.after.mul(light).mul(light);
  const cv::Mat least = power.noise + kTolerance * dimmed;
  const cv::Mat unexplained = power.before - 2 * power.common.mul(light) + dimmed;
  cv::Mat loss;
  cv::log(cv::max(unexplained, least) / cv::max(power.before, least), loss);
  return kSamples / 2 * loss;
}

}  // namespace mbncc::likelihood
