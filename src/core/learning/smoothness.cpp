#include "learning/smoothness.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr float kStrength = 16;         // gamma
constexpr float kSharpness = 2.5F;      // beta, for contrasts relative to their mean
constexpr float kPlatformEdge = 0.02F;  // weight of the after picture's contrast [1 / grey level^2]
constexpr float kMissing = -1;

// Squared contrast of `before` across one edge, less what `after` shows as well.
float object_contrast(const cv::Vec3f& before, const cv::Vec3f& after, const cv::Vec3f& precision) {
  const cv::Vec3f gone = before - after;
  float mismatch = 0;
  for (int c = 0; c < 3; ++c) mismatch += gone[c] * gone[c] * precision[c];
  const float shared = kPlatformEdge * after.dot(after) * std::exp(-std::min(20.F, mismatch));
  return before.dot(before) / (1 + shared);
}

struct Contrasts {
  std::array<cv::Mat, 4> squares;
  double mean = 0;
};

Contrasts measure(const cv::Mat& before, const cv::Mat& after, const cv::Vec3f& precision) {
  Contrasts contrasts;
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < contrasts.squares.size(); ++k) {
    cv::Mat& squares = contrasts.squares[k];
    squares = cv::Mat(before.size(), CV_32FC1, cv::Scalar(kMissing));
    const int dx = Smoothness::kDx[k], dy = Smoothness::kDy[k];
    for (int y = -dy; y < before.rows; ++y)
      for (int x = std::max(0, -dx); x < before.cols - std::max(0, dx); ++x) {
        const float square = object_contrast(
            before.at<cv::Vec3f>(y, x) - before.at<cv::Vec3f>(y + dy, x + dx),
            after.at<cv::Vec3f>(y, x) - after.at<cv::Vec3f>(y + dy, x + dx), precision);
        squares.at<float>(y, x) = square;
        sum += square;
        ++count;
      }
  }
  contrasts.mean = sum / std::max(1.0, count);
  return contrasts;
}

// Precision of the mismatch of two edges: each is a difference of two noisy pixels in each picture.
cv::Vec3f edge_precision(const NoiseModel& noise) {
  cv::Vec3f precision;
  for (int c = 0; c < 3; ++c) precision[c] = 1 / (24 * noise.sigma(c) * noise.sigma(c));
  return precision;
}

}  // namespace

Smoothness smoothness(const cv::Mat& before, const cv::Mat& after, const NoiseModel& noise) {
  Contrasts contrasts = measure(before, after, edge_precision(noise));
  const float beta = static_cast<float>(kSharpness / std::max(1e-3, contrasts.mean));
  Smoothness result;
  result.strength = kStrength;
  for (std::size_t k = 0; k < result.weights.size(); ++k) {
    const bool diagonal = Smoothness::kDx[k] != 0 && Smoothness::kDy[k] != 0;
    const float scale = diagonal ? kStrength / std::sqrt(2.F) : kStrength;
    cv::Mat& weights = result.weights[k] = contrasts.squares[k];
    for (float& w : cv::Mat_<float>(weights))
      w = w == kMissing ? 0 : scale * std::exp(-std::min(30.F, beta * w));
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

}  // namespace mbncc
