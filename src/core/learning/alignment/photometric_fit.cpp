// SPDX-License-Identifier: BSD-3-Clause
#include "learning/alignment/photometric_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numeric/order_statistics.hpp"

namespace mbncc::alignment {
namespace {

constexpr int kFinestStep = 3;        // [px] finest sampling step
constexpr double kEnough = 2000;      // samples that suffice
constexpr std::size_t kFewest = 200;  // samples; with fewer, the light is the identity
constexpr int kRounds = 5;            // most rounds of reweighting
constexpr double kSettled = 0.05;     // [grey levels] a smaller change of the light ends the fit
constexpr double kLeastSpread = 0.5;  // [grey levels] least spread, from rounding alone
constexpr float kNoShadow = 0.15F;    // part of the light, less than a shadow takes
constexpr float kLeastShadow = 8;     // [grey levels] added, because dark pixels are noisy
constexpr double kFrozen = 1e12;      // prior that keeps a term at 0

// One equation: difference = a g + a u gx + a v gy + offset.
struct Sample {
  cv::Vec4f terms;
  float difference;

  float residual(const cv::Vec4f& light) const {
    return difference -
           (terms[0] * light[0] + terms[1] * light[1] + terms[2] * light[2] + terms[3] * light[3]);
  }

  // Whether noise may explain the residual; a shadow in one of the images takes more light.
  bool is_plausible(const cv::Vec4f& light) const {
    const float deviation = residual(light), predicted = terms[0] + difference - deviation;
    return std::abs(deviation) < kNoShadow * std::max(predicted, 0.F) + kLeastShadow;
  }
};

using Samples = std::array<std::vector<Sample>, 3>;  // per channel

Samples samples_of(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted) {
  const int step = std::max(kFinestStep, cvRound(std::sqrt(cv::countNonZero(trusted) / kEnough)));
  Samples samples;
  cv::Mat row_before, row_after;
  for (int y = 0; y < after.rows; y += step) {
    before.row(y).convertTo(row_before, CV_32F);
    after.row(y).convertTo(row_after, CV_32F);
    const float v = (y - after.rows / 2) / float(after.rows);
    for (int x = (y / step) % 2; x < after.cols; x += step) {
      if (!trusted.at<uchar>(y, x)) continue;
      const float u = (x - after.cols / 2) / float(after.cols);
      const auto &b = row_before.at<cv::Vec3f>(x), &a = row_after.at<cv::Vec3f>(x);
      for (int c = 0; c < 3; ++c)
        samples[c].push_back({{a[c], a[c] * u, a[c] * v, 1}, b[c] - a[c]});
    }
  }
  return samples;
}

float spread_of(const std::vector<Sample>& samples, const cv::Vec4d& light) {
  std::vector<float> residuals;
  residuals.reserve(samples.size());
  for (const auto& sample : samples)
    if (sample.is_plausible(light)) residuals.push_back(std::abs(sample.residual(light)));
  const float median = residuals.empty() ? 0 : numeric::median(residuals);
  return numeric::deviation_of_mad(std::max(static_cast<float>(kLeastSpread), median));
}

// Weak priors, proportional to the number of samples, keep terms at 0 that the scene does not
// determine.
cv::Matx44d prior(double samples, bool planar) {
  const double plane = planar ? samples * 40 : kFrozen;
  return cv::Matx44d::diag({samples * 20, plane, plane, samples * 0.005});
}

// One weighted least squares step; samples beyond `cut` have weight 0.
cv::Vec4d reweighted(const std::vector<Sample>& samples, const cv::Vec4d& light, double cut,
                     bool planar) {
  cv::Matx44d normal = prior(static_cast<double>(samples.size()), planar);
  cv::Vec4d right(0, 0, 0, 0);
  for (const auto& sample : samples) {
    const double r = sample.residual(light) / cut;
    if (std::abs(r) >= 1 || !sample.is_plausible(light)) continue;
    const double weight = (1 - r * r) * (1 - r * r);
    for (int i = 0; i < 4; ++i) {
      right[i] += weight * sample.terms[i] * sample.difference;
      for (int j = 0; j <= i; ++j) normal(i, j) += weight * sample.terms[i] * sample.terms[j];
    }
  }
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) normal(i, j) = normal(j, i);
  return normal.solve(right, cv::DECOMP_CHOLESKY);
}

float median_difference(const std::vector<Sample>& samples) {
  std::vector<float> differences;
  differences.reserve(samples.size());
  for (const auto& sample : samples) differences.push_back(static_cast<float>(sample.difference));
  return numeric::median(differences);
}

// Largest difference [grey levels] that two lights make on a pixel of medium brightness.
double difference_of(const cv::Vec4d& a, const cv::Vec4d& b) {
  const cv::Vec4d d = a - b;
  return 128 * (std::abs(d[0]) + std::abs(d[1]) / 2 + std::abs(d[2]) / 2) + std::abs(d[3]);
}

ChannelLight fit_channel(const std::vector<Sample>& samples, bool planar) {
  if (samples.size() < kFewest) return {};
  cv::Vec4d light(0, 0, 0, median_difference(samples));
  for (int round = 0; round < kRounds; ++round) {
    const double cut = (round == 0 ? 4 : 3) * spread_of(samples, light);
    const cv::Vec4d next = reweighted(samples, light, cut, planar);
    const bool settled = difference_of(next, light) < kSettled;
    light = next;
    if (settled) break;
  }
  return {light[0], light[1], light[2], light[3]};
}

}  // namespace

Light fit_light(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted, bool planar) {
  const Samples samples = samples_of(before, after, trusted);
  Light light;
  for (int c = 0; c < 3; ++c) light[c] = fit_channel(samples[c], planar);
  return light;
}

cv::Mat apply_light(const cv::Mat& after, const Light& light, const cv::Range& rows) {
  const cv::Range range = rows == cv::Range::all() ? cv::Range(0, after.rows) : rows;
  cv::Mat lit;
  after.rowRange(range).convertTo(lit, CV_32F);
  for (int y = range.start; y < range.end; ++y) {
    auto* values = lit.ptr<float>(y - range.start);
    const double v = (y - after.rows / 2) / double(after.rows);
    for (int c = 0; c < 3; ++c) {
      const auto& l = light[c];
      const auto slope = static_cast<float>(l.gain_x / after.cols);
      const auto start = static_cast<float>(1 + l.gain + l.gain_y * v - slope * (after.cols / 2));
      const auto offset = static_cast<float>(l.offset);
      for (int x = 0; x < after.cols; ++x) {
        float& value = values[3 * x + c];
        value = value * (start + slope * static_cast<float>(x)) + offset;
      }
    }
  }
  return lit;
}

}  // namespace mbncc::alignment
