// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/texture_change.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "numeric/order_statistics.hpp"

namespace mbncc::change {
namespace {

constexpr int kTextureBox = 15;       // [px] side of the squares in which texture is compared
constexpr double kTextured = 9;       // [grey levels^2] variance above which a square has texture
constexpr double kSameTexture = 0.5;  // least correlation of squares that show the same texture
// [grey levels^2] Variance from which noise adds no noticeable contrast.
constexpr double kContrasty = 36;
constexpr double kWhite = 255;
constexpr int kSampling = 4;          // [px] for the median of contrast
constexpr std::size_t kFewest = 200;  // least number of samples of contrast

// Means over small squares of a product of two images.
cv::Mat mean_product(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat mean = a.mul(b);
  cv::boxFilter(mean, mean, CV_32F, {kTextureBox, kTextureBox});
  return mean;
}

// Noise and faulty pixels are not displaced texture.
cv::Mat without_noise(const cv::Mat& image) {
  cv::Mat clean;
  cv::medianBlur(image, clean, 3);
  return clean;
}

cv::Mat box_mean(const cv::Mat& values) {
  cv::Mat mean;
  cv::boxFilter(values, mean, CV_32F, {kTextureBox, kTextureBox});
  return mean;
}

// Whether a square of this mean and variance has pixels near `white`, where contrast is lost.
bool reaches(double white, double mean, double variance) {
  return mean + 2 * std::sqrt(variance) > 0.95 * white;
}

struct Squares {
  int squares = 0, displaced = 0;

  void count(bool is_displaced) {
    ++squares;
    displaced += is_displaced;
  }
  double displaced_part() const {
    return squares == 0 ? 0 : displaced / static_cast<double>(squares);
  }
};

TextureChange compare_squares(const cv::Mat& before, const cv::Mat& after, double white) {
  const cv::Mat mean_b = box_mean(before), mean_a = box_mean(after);
  const cv::Mat bb = mean_product(before, before), aa = mean_product(after, after),
                ba = mean_product(before, after);
  Squares textured_before, textured_after;
  std::vector<float> contrasts;
  for (int y = 0; y < before.rows; ++y) {
    const auto *b = mean_b.ptr<float>(y), *a = mean_a.ptr<float>(y);
    for (int x = 0; x < before.cols; ++x) {
      const double vb = bb.at<float>(y, x) - b[x] * b[x], va = aa.at<float>(y, x) - a[x] * a[x];
      if (std::max(vb, va) < kTextured) continue;
      const float covariance = ba.at<float>(y, x) - b[x] * a[x];
      const bool displaced =
          covariance < kSameTexture * std::sqrt(std::max(kTextured, vb) * std::max(kTextured, va));
      if (vb >= kTextured) textured_before.count(displaced);
      if (va >= kTextured) textured_after.count(displaced);
      if (displaced || x % kSampling != 0 || y % kSampling != 0 || std::min(vb, va) < kContrasty)
        continue;
      if (reaches(kWhite, b[x], vb) || reaches(white, a[x], va)) continue;
      contrasts.push_back(static_cast<float>(std::sqrt(vb / va)));
    }
  }
  return {std::min(textured_before.displaced_part(), textured_after.displaced_part()),
          contrasts.size() < kFewest ? 1 : numeric::median(contrasts)};
}

}  // namespace

TextureChange texture_change(const cv::Mat& before, const cv::Mat& after, double white) {
  return compare_squares(without_noise(before), without_noise(after), white);
}

}  // namespace mbncc::change
