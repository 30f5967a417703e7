// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/coloured_shadow.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr float kLeastLight = 0.2F, kMostLight = 0.92F;  // limits of the light that a shadow leaves
// Relative to the chroma of the shadowed colour: largest loss, and largest deviation across it
constexpr float kOther = 0.4F;
constexpr float kVisible = 3;  // [sigma] least chroma of the shadowed colour

cv::Vec3f chroma(const cv::Vec3f& colour) {
  return colour - cv::Vec3f::all((colour[0] + colour[1] + colour[2]) / 3);
}

// Whether `seen` has the hue of `expected` and its chroma or more, because a shadow also takes away
// what a glossy platform reflects.
bool has_hue(const cv::Vec3f& seen, const cv::Vec3f& expected) {
  const float along = seen.dot(expected) / expected.dot(expected);
  const cv::Vec3f across = seen - along * expected;
  return along > 1 - kOther && across.dot(across) < kOther * kOther * along * seen.dot(expected);
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
      const cv::Vec3f expected = light * chroma(a);
      if (expected.dot(expected) > kVisible * kVisible * sigma * sigma &&
          has_hue(chroma(b), expected))
        shadow.at<uchar>(y, x) = 255;
    }
  return shadow;
}

}  // namespace mbncc::likelihood
