// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/coloured_shadow.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr float kLeastLight = 0.2F, kMostLight = 0.92F;  // limits of the light that a shadow leaves
// Largest distance to the shadowed colour, relative to the distance of that colour from grey.
constexpr float kNearer = 0.4F;
constexpr float kVisible = 3;  // [sigma] least distance of the shadowed colour from grey

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
      const cv::Vec3f off = b - light * a,
                      chroma = light * (a - cv::Vec3f::all((a[0] + a[1] + a[2]) / 3));
      const float from_grey = chroma.dot(chroma);
      if (from_grey > kVisible * kVisible * sigma * sigma &&
          off.dot(off) < kNearer * kNearer * from_grey)
        shadow.at<uchar>(y, x) = 255;
    }
  return shadow;
}

}  // namespace mbncc::likelihood
