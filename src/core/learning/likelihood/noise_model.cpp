// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/noise_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "learning/likelihood/normalized_difference.hpp"
#include "numeric/order_statistics.hpp"

namespace mbncc::likelihood {
namespace {

constexpr float kLeastSigma = 0.6F;      // [grey levels] rounding to 8 bits in two images
constexpr float kUnknownSigma = 4;       // [grey levels] used if the ring is too small
constexpr float kFlatGradient = 64;      // [(grey levels / px)^2] below this, no edge disturbs
constexpr float kClipped = 252;          // [grey levels]
constexpr float kPooledQuantile = 4.9F;  // 90 % quantile of a pooled chi^2 of three channels

// Differences on trusted pixels: by brightness where the image is flat, by gradient elsewhere.
struct Differences {
  std::array<std::vector<float>, 3> flat;
  std::array<std::array<std::vector<float>, NoiseModel::kBins>, 3> flat_by_brightness;
  std::vector<cv::Vec2f> sloped;  // squared difference, squared gradient; green channel
};

int brightness_bin(float value) {
  constexpr float kWidth = 256.F / NoiseModel::kBins;  // [grey levels]
  return std::clamp(static_cast<int>(value / kWidth), 0, NoiseModel::kBins - 1);
}

float squared_gradient(const cv::Mat& image, int y, int x, int channel) {
  const float gx =
      (image.at<cv::Vec3f>(y, x + 1)[channel] - image.at<cv::Vec3f>(y, x - 1)[channel]) / 2;
  const float gy =
      (image.at<cv::Vec3f>(y + 1, x)[channel] - image.at<cv::Vec3f>(y - 1, x)[channel]) / 2;
  return gx * gx + gy * gy;
}

void collect_pixel(const alignment::AlignedPair& pair, int y, int x, Differences& differences) {
  for (int c = 0; c < 3; ++c) {
    const float a = pair.after.at<cv::Vec3f>(y, x)[c], b = pair.before.at<cv::Vec3f>(y, x)[c];
    if (a > kClipped && b > kClipped) continue;
    const float gradient = squared_gradient(pair.after, y, x, c);
    if (gradient < kFlatGradient) {
      differences.flat[c].push_back(std::abs(b - a));
      differences.flat_by_brightness[c][brightness_bin(a)].push_back(std::abs(b - a));
    }
    if (c == 1 && gradient > 36) differences.sloped.emplace_back((b - a) * (b - a), gradient);
  }
}

// Visits about `enough` trusted pixels, none on the window's border.
template <class Visit>
void for_each_trusted(const alignment::AlignedPair& pair, int enough, Visit&& visit) {
  const int step =
      std::max(2, static_cast<int>(cv::countNonZero(pair.trusted) / static_cast<double>(enough)));
  int seen = 0;
  for (int y = 1; y < pair.trusted.rows - 1; ++y) {
    const auto* trusted = pair.trusted.ptr<uchar>(y);
    for (int x = 1; x < pair.trusted.cols - 1; ++x)
      if (trusted[x] && ++seen % step == 0) visit(y, x);
  }
}

Differences collect(const alignment::AlignedPair& pair) {
  Differences differences;
  for_each_trusted(pair, 12000, [&](int y, int x) { collect_pixel(pair, y, x, differences); });
  return differences;
}

// The median of integer differences is coarse, so the 68 % quantile is used as well.
float robust_sigma(std::vector<float>& differences) {
  return std::max({kLeastSigma, numeric::deviation_of_mad(numeric::median(differences)),
                   numeric::quantile(differences, 0.683)});
}

// Bins with few samples are regularised by the whole channel and by their neighbours.
NoiseModel::Channel channel_variance(std::vector<float>& all,
                                     std::array<std::vector<float>, NoiseModel::kBins>& bins) {
  const float overall = all.size() < 100 ? kUnknownSigma : robust_sigma(all);
  NoiseModel::Channel own{}, smooth{};
  for (int k = 0; k < NoiseModel::kBins; ++k) {
    const float sigma = bins[k].size() > 30 ? robust_sigma(bins[k]) : overall;
    const float trust = static_cast<float>(bins[k].size()) / (bins[k].size() + 200.F);
    own[k] = trust * sigma * sigma + (1 - trust) * overall * overall;
  }
  for (int k = 0; k < NoiseModel::kBins; ++k) {
    float sum = 0, weights = 0;
    for (int j = std::max(0, k - 1); j <= std::min(k + 1, NoiseModel::kBins - 1); ++j) {
      const float weight = (bins[j].size() + 21.F) * (j == k ? 1.F : 0.5F);
      sum += weight * own[j];
      weights += weight;
    }
    smooth[k] = sum / weights;
  }
  return smooth;
}

// Slope of the squared difference over the squared gradient, from robust means of gradient classes.
float gradient_part(const std::vector<cv::Vec2f>& sloped, float sigma) {
  constexpr std::array<float, 5> kClassEnds{100, 225, 400, 900, 2500};
  constexpr float kQuantileOfChi2 = 0.708F;  // 60 % quantile of chi^2 of one channel
  std::array<std::vector<float>, kClassEnds.size() + 1> classes;
  std::array<double, kClassEnds.size() + 1> gradients{};
  for (const auto& sample : sloped) {
    const auto end = std::upper_bound(kClassEnds.begin(), kClassEnds.end(), sample[1]);
    const auto k = static_cast<std::size_t>(end - kClassEnds.begin());
    classes[k].push_back(sample[0]);
    gradients[k] += sample[1];
  }
  double numerator = 0, denominator = 0;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if (classes[k].size() <= 40) continue;
    const auto n = static_cast<double>(classes[k].size());
    const double variance = numeric::quantile(classes[k], 0.6) / kQuantileOfChi2;
    const double gradient = gradients[k] / n;
    numerator += n * std::max(0.0, variance - sigma * sigma) * gradient;
    denominator += n * gradient * gradient;
  }
  if (denominator == 0) return NoiseModel().gradient_part;
  return static_cast<float>(std::clamp(numerator / denominator, 0.0016, 0.09));
}

// Differences in units of their standard deviations.
cv::Vec3f deviations_at(const alignment::AlignedPair& pair, const NoiseModel& noise, int y, int x) {
  cv::Vec3f result = pair.before.at<cv::Vec3f>(y, x) - pair.after.at<cv::Vec3f>(y, x);
  const cv::Vec3f variance = noise.variance_at(pair.after, y, x);
  for (int c = 0; c < 3; ++c) result[c] /= std::sqrt(variance[c]);
  return result;
}

// Correlation of the channels' differences. Outliers are excluded; a tenth of
// independent noise keeps the matrix well conditioned.
cv::Matx33f channel_correlation(const alignment::AlignedPair& pair, const NoiseModel& noise) {
  constexpr float kFarthest = 18.75F;   // squared deviations, over the three channels
  constexpr double kPriorSamples = 50;  // of independent channels
  constexpr double kCorrelatedPart = 0.9;
  cv::Matx33d sum = cv::Matx33d::eye() * kPriorSamples;
  for_each_trusted(pair, 2500, [&](int y, int x) {
    const cv::Vec3f deviation = deviations_at(pair, noise, y, x);
    if (deviation.dot(deviation) < kFarthest) sum += cv::Matx33d(deviation * deviation.t());
  });
  cv::Matx33f result = cv::Matx33f::eye();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j)
        result(i, j) =
            static_cast<float>(kCorrelatedPart * sum(i, j) / std::sqrt(sum(i, i) * sum(j, j)));
  return result;
}

// JPEG and demosaicing leave tails heavier than a normal distribution's.
float tail_factor(const alignment::AlignedPair& pair, const NoiseModel& noise) {
  const cv::Matx33f precision = noise.correlation.inv(cv::DECOMP_CHOLESKY);
  std::vector<float> values;
  for_each_trusted(pair, 1200, [&](int y, int x) {
    float mean = 0, here = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const cv::Vec3f deviation = deviations_at(pair, noise, y + dy, x + dx);
        const float distance = deviation.dot(precision * deviation);
        mean += distance / 9;
        if (dx == 0 && dy == 0) here = distance;
      }
    values.push_back((1 - kPooledPart) * here + kPooledPart * mean);
  });
  if (values.size() <= 50) return 1;
  return std::clamp(numeric::quantile(values, 0.9) / kPooledQuantile, 1.F, 4.F);
}

}  // namespace

cv::Vec3f NoiseModel::variance_at(const cv::Mat& after, int y, int x) const {
  const auto* row = after.ptr<cv::Vec3f>(y);
  const cv::Vec3f gx = row[std::min(x + 1, after.cols - 1)] - row[std::max(x - 1, 0)];
  const cv::Vec3f gy = after.ptr<cv::Vec3f>(std::min(y + 1, after.rows - 1))[x] -
                       after.ptr<cv::Vec3f>(std::max(y - 1, 0))[x];
  cv::Vec3f result;
  for (int c = 0; c < 3; ++c)
    result[c] = variance[c][brightness_bin(row[x][c])] +
                gradient_part * (gx[c] * gx[c] + gy[c] * gy[c]) / 4;
  return result;
}

cv::Mat NoiseModel::variance_image(const cv::Mat& after) const {
  cv::Mat result(after.size(), CV_32FC3);
  for (int y = 0; y < after.rows; ++y) {
    auto* out = result.ptr<cv::Vec3f>(y);
    for (int x = 0; x < after.cols; ++x) out[x] = variance_at(after, y, x);
  }
  return result;
}

float NoiseModel::sigma(int channel) const {
  const auto& bins = variance[channel];
  return std::sqrt(std::accumulate(bins.begin(), bins.end(), 0.F) / kBins);
}

NoiseModel learn_noise(const alignment::AlignedPair& pair) {
  Differences differences = collect(pair);
  NoiseModel noise;
  for (int c = 0; c < 3; ++c)
    noise.variance[c] = channel_variance(differences.flat[c], differences.flat_by_brightness[c]);
  noise.gradient_part = gradient_part(differences.sloped, noise.sigma(1));
  noise.correlation = channel_correlation(pair, noise);
  noise.tail = tail_factor(pair, noise);
  return noise;
}

}  // namespace mbncc::likelihood
