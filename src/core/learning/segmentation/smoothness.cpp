// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace mbncc::segmentation {
namespace {

constexpr float kStrength = 16;         // gamma
constexpr float kSharpness = 2.5F;      // beta, for contrasts relative to their mean
constexpr float kPlatformEdge = 0.02F;  // weight of the after image's contrast [1 / grey level^2]
constexpr float kMissing = -1;

struct Contrasts {
  std::array<cv::Mat, 4> squares;
  double mean = 0;
};

// Squared contrasts of `before` across edges of one row, reduced where `after` shows the same edge.
class RowContrast {
 public:
  RowContrast(int width, const cv::Vec3f& precision)
      : precision_(precision), other_(1, width, CV_32FC1), alike_(1, width, CV_32FC1) {}

  // Measures `count` edges between pixels (index 0) and their neighbours (index 1) in both images.
  void measure(const std::array<const cv::Vec3f*, 2>& before,
               const std::array<const cv::Vec3f*, 2>& after, int count, float* squares) {
    cv::Mat alike_row = alike_.colRange(0, count);
    auto *other = other_.ptr<float>(), *alike = alike_.ptr<float>();
    for (int x = 0; x < count; ++x) {
      const cv::Vec3f b = before[0][x] - before[1][x], a = after[0][x] - after[1][x], gone = b - a;
      float mismatch = 0;
      for (int c = 0; c < 3; ++c) mismatch += gone[c] * gone[c] * precision_[c];
      alike[x] = -std::min(20.F, mismatch);
      other[x] = a.dot(a);
      squares[x] = b.dot(b);
    }
    cv::exp(alike_row, alike_row);
    for (int x = 0; x < count; ++x) squares[x] /= 1 + kPlatformEdge * other[x] * alike[x];
  }

 private:
  cv::Vec3f precision_;
  cv::Mat other_, alike_;  // squared contrasts of `after`, and their similarity to `before`
};

Contrasts measure(const cv::Mat& before, const cv::Mat& after, const cv::Vec3f& precision) {
  Contrasts contrasts;
  RowContrast row(before.cols, precision);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < contrasts.squares.size(); ++k) {
    cv::Mat& squares = contrasts.squares[k];
    squares = cv::Mat(before.size(), CV_32FC1, cv::Scalar(kMissing));
    const int dx = Smoothness::kDx[k], dy = Smoothness::kDy[k];
    const int begin = std::max(0, -dx), edges = before.cols - std::abs(dx);
    for (int y = -dy; y < before.rows; ++y) {
      const auto ends = [&](const cv::Mat& image) -> std::array<const cv::Vec3f*, 2> {
        return {image.ptr<cv::Vec3f>(y) + begin, image.ptr<cv::Vec3f>(y + dy) + begin + dx};
      };
      auto* out = squares.ptr<float>(y) + begin;
      row.measure(ends(before), ends(after), edges, out);
      sum = std::accumulate(out, out + edges, sum);
      count += edges;
    }
  }
  contrasts.mean = sum / std::max(1.0, count);
  return contrasts;
}

// Precision of the mismatch of two edges: each is a difference of two noisy pixels in each image.
cv::Vec3f edge_precision(const likelihood::NoiseModel& noise) {
  cv::Vec3f precision;
  for (int c = 0; c < 3; ++c) precision[c] = 1 / (24 * noise.sigma(c) * noise.sigma(c));
  return precision;
}

}  // namespace

Smoothness smoothness(const cv::Mat& before, const cv::Mat& after,
                      const likelihood::NoiseModel& noise) {
  Contrasts contrasts = measure(before, after, edge_precision(noise));
  const float beta = static_cast<float>(kSharpness / std::max(1e-3, contrasts.mean));
  Smoothness result;
  result.strength = kStrength;
  for (std::size_t k = 0; k < result.weights.size(); ++k) {
    const bool diagonal = Smoothness::kDx[k] != 0 && Smoothness::kDy[k] != 0;
    const float scale = diagonal ? kStrength / std::sqrt(2.F) : kStrength;
    cv::Mat& weights = result.weights[k];
    cv::exp(cv::max(contrasts.squares[k] * -beta, -30), weights);
    weights *= scale;
    weights.setTo(0, contrasts.squares[k] == kMissing);
  }
  return result;
}

Smoothness with_free_rim(const Smoothness& smoothness, const cv::Mat& mask) {
  Smoothness result;
  result.strength = smoothness.strength;
  for (std::size_t k = 0; k < result.weights.size(); ++k) {
    const cv::Point step(Smoothness::kDx[k], Smoothness::kDy[k]);
    cv::Mat& weights = result.weights[k] = smoothness.weights[k].clone();
    for (int y = 0; y < weights.rows; ++y)
      for (int x = 0; x < weights.cols; ++x) {
        float& weight = weights.at<float>(y, x);
        if (weight > 0 && mask.at<uchar>(y, x) != mask.at<uchar>(cv::Point(x, y) + step))
          weight = 0;
      }
  }
  return result;
}

}  // namespace mbncc::segmentation
