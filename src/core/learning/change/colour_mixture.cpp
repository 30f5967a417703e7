// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/colour_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbncc::change {
namespace {

constexpr int kMostComponents = 5;
constexpr int kMostSamples = 3000;
constexpr int kFewestSamples = 20;
constexpr int kRounds = 2;          // of reassignment
constexpr double kLeastSpread = 4;  // [grey levels^2] narrower clusters are not split
constexpr double kRegularity = 16;  // [grey levels^2] added to each covariance's diagonal
// Least weight of a sample, so that a few certain pixels do not form a component.
constexpr float kLeastWeight = 0.01F;
const double kLog2Pi = std::log(2 * CV_PI);

struct Sample {
  cv::Vec3f colour;
  float weight;
  int component = 0;
};

struct Moments {
  double weight = 0;
  cv::Vec3d mean;
  cv::Matx33d covariance;

  void add(const Sample& sample) {
    const cv::Vec3d colour = sample.colour;
    weight += sample.weight;
    mean += sample.weight * colour;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) covariance(i, j) += sample.weight * (colour[i] * colour[j]);
  }

  // Converts the sums to means.
  void finish() {
    if (weight <= 0) return;
    mean *= 1 / weight;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        covariance(j, i) = covariance(i, j) = covariance(i, j) * (1 / weight) - mean[i] * mean[j];
  }
};

std::vector<Sample> draw_samples(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& weight) {
  const int step = std::max(1, cv::countNonZero(mask) / kMostSamples);
  std::vector<Sample> samples;
  int seen = 0;
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      if (mask.at<uchar>(y, x) && seen++ % step == 0)
        samples.push_back({image.at<cv::Vec3f>(y, x),
                           weight.empty() ? 1 : std::max(kLeastWeight, weight.at<float>(y, x))});
  return samples;
}

// Moments of the first `count` components.
std::vector<Moments> moments_of(const std::vector<Sample>& samples, int count) {
  std::vector<Moments> moments(count);
  for (const auto& sample : samples) moments[sample.component].add(sample);
  for (auto& component : moments) component.finish();
  return moments;
}

// Main axis by power iteration; a fixed start keeps it repeatable.
cv::Vec3d main_axis(const cv::Matx33d& covariance) {
  cv::Vec3d axis(1, 0.9, 0.8);
  for (int i = 0; i < 12; ++i) {
    axis = covariance * axis;
    const double length = cv::norm(axis);
    if (length < 1e-9) break;
    axis *= 1 / length;
  }
  return axis;
}

// Splits the component with the largest spread along its main axis (Orchard and Bouman). False if
// none is wide enough.
bool split_widest(std::vector<Sample>& samples, int count) {
  double widest = 0;
  int chosen = -1;
  cv::Vec3d axis, mean;
  const auto moments = moments_of(samples, count);
  for (int k = 0; k < count; ++k) {
    const Moments& m = moments[k];
    if (m.weight <= 0) continue;
    const cv::Vec3d a = main_axis(m.covariance);
    const double spread = a.dot(m.covariance * a) * m.weight;
    if (spread <= widest) continue;
    widest = spread;
    chosen = k;
    axis = a;
    mean = m.mean;
  }
  if (chosen < 0 || widest / static_cast<double>(samples.size()) < kLeastSpread) return false;
  for (auto& sample : samples)
    if (sample.component == chosen && axis.dot(cv::Vec3d(sample.colour) - mean) > 0)
      sample.component = count;
  return true;
}

}  // namespace

// Inline, so that loops over rows are vectorised.
inline float ColourMixture::Component::log_density(float blue, float green, float red) const {
  const float a = blue - mean[0], b = green - mean[1], c = red - mean[2];
  const auto& p = precision.val;
  const float distance =
      a * a * p[0] + b * b * p[4] + c * c * p[8] + 2 * (a * b * p[1] + a * c * p[2] + b * c * p[5]);
  return log_weight - 0.5F * distance;
}

inline float ColourMixture::Component::log_density(const cv::Vec3f& colour) const {
  return log_density(colour[0], colour[1], colour[2]);
}

class MixtureFit {
 public:
  explicit MixtureFit(std::vector<Sample> samples) : samples_(std::move(samples)) {}

  ColourMixture run() {
    while (count_ < kMostComponents && split_widest(samples_, count_)) ++count_;
    estimate();
    for (int round = 0; round < kRounds; ++round) {
      reassign();
      estimate();
    }
    return std::move(mixture_);
  }

 private:
  void estimate() {
    mixture_.components_.clear();
    double total = 0;
    for (const auto& sample : samples_) total += sample.weight;
    for (const Moments& m : moments_of(samples_, count_)) {
      if (m.weight <= 0) continue;
      const cv::Matx33d covariance = m.covariance + cv::Matx33d::eye() * kRegularity;
      ColourMixture::Component component;
      component.mean = m.mean;
      component.precision = covariance.inv(cv::DECOMP_CHOLESKY);
      component.log_weight = static_cast<float>(
          std::log(m.weight / total) - 0.5 * std::log(cv::determinant(covariance)) - 1.5 * kLog2Pi);
      mixture_.components_.push_back(component);
    }
    count_ = static_cast<int>(mixture_.components_.size());
  }

  void reassign() {
    for (auto& sample : samples_) {
      float best = -std::numeric_limits<float>::infinity();
      for (int k = 0; k < count_; ++k) {
        const float log_density = mixture_.components_[k].log_density(sample.colour);
        if (log_density <= best) continue;
        best = log_density;
        sample.component = k;
      }
    }
  }

  std::vector<Sample> samples_;
  int count_ = 1;
  ColourMixture mixture_;
};

ColourMixture ColourMixture::fit(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& weight) {
  auto samples = draw_samples(image, mask, weight);
  if (samples.size() < kFewestSamples) return {};
  return MixtureFit(std::move(samples)).run();
}

cv::Mat ColourMixture::densities(const cv::Mat& image) const {
  cv::Mat sum = cv::Mat::zeros(image.size(), CV_32FC1);
  cv::Mat planes(3, image.cols, CV_32FC1), part(1, image.cols, CV_32FC1);
  for (int y = 0; y < image.rows; ++y) {
    const auto* colours = image.ptr<cv::Vec3f>(y);
    auto *blue = planes.ptr<float>(0), *green = planes.ptr<float>(1), *red = planes.ptr<float>(2);
    for (int x = 0; x < image.cols; ++x) {
      blue[x] = colours[x][0];
      green[x] = colours[x][1];
      red[x] = colours[x][2];
    }
    auto* logs = part.ptr<float>();
    auto* out = sum.ptr<float>(y);
    for (const auto& component : components_) {
      const Component gaussian = component;  // local copy that the loop cannot alias
      for (int x = 0; x < image.cols; ++x)
        logs[x] = gaussian.log_density(blue[x], green[x], red[x]);
      cv::exp(part, part);
      for (int x = 0; x < image.cols; ++x) out[x] += logs[x];
    }
  }
  return sum;
}

float ColourMixture::density(const cv::Vec3f& colour) const {
  float sum = 0;
  for (const auto& component : components_) sum += std::exp(component.log_density(colour));
  return sum;
}

}  // namespace mbncc::change
