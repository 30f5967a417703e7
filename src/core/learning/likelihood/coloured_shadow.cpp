// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/coloured_shadow.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr float kLeastLight = 0.2F, kMostLight = 0.92F;  // limits of the light that a shadow leaves
constexpr float kOtherChroma = 0.4F;                     // largest difference in chroma, relative
constexpr float kOtherHue = 0.4F;                        // largest tangent of the difference in hue
// A shadow also takes away what a glossy platform reflects, and is more saturated then: at least
// this chroma relative to its brightness, because the hue of pale colours says little, ...
constexpr float kSaturated = 0.3F;
constexpr float kMostChroma = 2;  // ... and at most this multiple of the lit platform's chroma
constexpr float kVisible = 3;     // [sigma] least chroma of the shadowed colour

float brightness(const cv::Vec3f& colour) {
  return (colour[0] + colour[1] + colour[2]) / 3;
}

cv::Vec3f chroma(const cv::Vec3f& colour) {
  return colour - cv::Vec3f::all(brightness(colour));
}

// Whether `seen` may be `platform` in this part of its light.
bool is_shadow_of(const cv::Vec3f& platform, float light, const cv::Vec3f& seen, float sigma) {
  const cv::Vec3f expected = light * chroma(platform), own = chroma(seen);
  const float square = expected.dot(expected);
  if (square <= kVisible * kVisible * sigma * sigma) return false;
  const float along = own.dot(expected) / square;
  const cv::Vec3f across = own - along * expected;
  if (along < 1 - kOtherChroma || cv::norm(across) > kOtherHue * along * std::sqrt(square))
    return false;
  return along < 1 + kOtherChroma ||
         (cv::norm(own) > kSaturated * brightness(seen) && along * light < kMostChroma);
}

}  // namespace

cv::Mat coloured_shadow(const cv::Mat& before, const cv::Mat& after, float sigma) {
  cv::Mat seen, platform, shadow = cv::Mat::zeros(before.size(), CV_8UC1);
  cv::blur(before, seen, {3, 3});
  cv::blur(after, platform, {3, 3});
  for (int y = 0; y < shadow.rows; ++y)
    for (int x = 0; x < shadow.cols; ++x) {
      const cv::Vec3f b = seen.at<cv::Vec3f>(y, x), a = platform.at<cv::Vec3f>(y, x);
      const float light = b.dot(a) / (a.dot(a) + 1);
      if (light < kLeastLight || light > kMostLight) continue;
      if (is_shadow_of(a, light, b, sigma)) shadow.at<uchar>(y, x) = 255;
    }
  return shadow;
}

}  // namespace mbncc::likelihood
