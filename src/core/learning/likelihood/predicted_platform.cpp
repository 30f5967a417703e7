// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/predicted_platform.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "imaging/rectangles.hpp"
#include "numeric/order_statistics.hpp"

namespace mbncc::likelihood {
namespace {

constexpr int kLeastRing = 12;          // [px] least width of the ring
constexpr double kRingPart = 0.3;       // width of the ring, as a part of the region's longer side
constexpr int kTerms = 6;               // coefficients of a second-degree surface
constexpr int kRounds = 6;              // rounds of reweighting
constexpr double kSamples = 4000;       // number of samples that is enough
constexpr float kLeastSpread = 1.5F;    // [grey levels] least spread
constexpr float kTukey = 4;             // [standard deviations] cut-off of Tukey's weights
constexpr double kExplainedPart = 0.5;  // least part of the ring that the surface must explain

using Terms = cv::Vec<double, kTerms>;
using Surface = std::array<Terms, 3>;

Terms terms_at(const cv::Size& size, int x, int y) {
  const double u = 2.0 * x / size.width - 1, v = 2.0 * y / size.height - 1;
  return {1, u, v, u * u, u * v, v * v};
}

cv::Vec3f value_at(const Surface& surface, const Terms& terms) {
  return {static_cast<float>(surface[0].dot(terms)), static_cast<float>(surface[1].dot(terms)),
          static_cast<float>(surface[2].dot(terms))};
}

struct Sample {
  Terms terms;
  cv::Vec3f colour;
};

std::vector<Sample> samples_of(const cv::Mat& image, const cv::Mat& ring) {
  const int step = std::max(1, cvRound(std::sqrt(cv::countNonZero(ring) / kSamples)));
  std::vector<Sample> samples;
  for (int y = 0; y < ring.rows; y += step)
    for (int x = 0; x < ring.cols; x += step)
      if (ring.at<uchar>(y, x))
        samples.push_back({terms_at(ring.size(), x, y), image.at<cv::Vec3f>(y, x)});
  return samples;
}

// Largest difference over the channels.
float misfit(const cv::Vec3f& a, const cv::Vec3f& b) {
  const cv::Vec3f d = a - b;
  return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}

std::vector<float> misfits(const std::vector<Sample>& samples, const Surface& surface) {
  std::vector<float> result;
  for (const Sample& sample : samples)
    result.push_back(misfit(sample.colour, value_at(surface, sample.terms)));
  return result;
}

float spread_of(std::vector<float> misfits) {
  return std::max(kLeastSpread, numeric::deviation_of_mad(numeric::median(misfits)));
}

Surface reweighted(const std::vector<Sample>& samples, const std::vector<float>& misfits,
                   float cut) {
  cv::Matx<double, kTerms, kTerms> normal = cv::Matx<double, kTerms, kTerms>::eye() * 1e-3;
  Surface right{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double r = misfits[i] / cut;
    if (r >= 1) continue;
    const double weight = (1 - r * r) * (1 - r * r);
    const Terms& t = samples[i].terms;
    normal += weight * t * t.t();
    for (int c = 0; c < 3; ++c) right[c] += weight * samples[i].colour[c] * t;
  }
  Surface surface;
  for (int c = 0; c < 3; ++c) surface[c] = normal.solve(right[c], cv::DECOMP_CHOLESKY);
  return surface;
}

cv::Vec3f median_colour(const std::vector<Sample>& samples) {
  cv::Vec3f colour;
  for (int c = 0; c < 3; ++c) {
    std::vector<float> values;
    for (const Sample& sample : samples) values.push_back(sample.colour[c]);
    colour[c] = numeric::median(values);
  }
  return colour;
}

Surface fit_surface(const std::vector<Sample>& samples) {
  Surface surface;
  const cv::Vec3f start = median_colour(samples);
  for (int c = 0; c < 3; ++c) surface[c] = Terms(start[c], 0, 0, 0, 0, 0);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<float> left = misfits(samples, surface);
    surface = reweighted(samples, left, kTukey * spread_of(left));
  }
  return surface;
}

}  // namespace

alignment::AlignedPair predict_platform(const cv::Mat& before, const cv::Rect& region) {
  const int width =
      std::max(kLeastRing, static_cast<int>(kRingPart * std::max(region.width, region.height)));
  alignment::AlignedPair pair;
  pair.predicted = true;
  pair.window = imaging::grown(region, width) & cv::Rect({0, 0}, before.size());
  before(pair.window).convertTo(pair.before, CV_32F);
  cv::Mat ring(pair.window.size(), CV_8UC1, cv::Scalar(255));
  ring(region - pair.window.tl()).setTo(0);
  const std::vector<Sample> samples = samples_of(pair.before, ring);
  const Surface surface = samples.empty() ? Surface{} : fit_surface(samples);
  const float limit = kTukey * spread_of(misfits(samples, surface));
  pair.after = cv::Mat(pair.window.size(), CV_32FC3);
  pair.trusted = cv::Mat::zeros(pair.window.size(), CV_8UC1);
  for (int y = 0; y < ring.rows; ++y)
    for (int x = 0; x < ring.cols; ++x) {
      cv::Vec3f& predicted = pair.after.at<cv::Vec3f>(y, x);
      predicted = value_at(surface, terms_at(ring.size(), x, y));
      for (int c = 0; c < 3; ++c) predicted[c] = std::clamp(predicted[c], 0.F, 255.F);
      if (ring.at<uchar>(y, x) && misfit(pair.before.at<cv::Vec3f>(y, x), predicted) < limit)
        pair.trusted.at<uchar>(y, x) = 255;
    }
  if (cv::countNonZero(pair.trusted) < kExplainedPart * cv::countNonZero(ring)) pair.trusted = ring;
  return pair;
}

}  // namespace mbncc::likelihood
