// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/exclusion_votes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc::segmentation {
namespace {

constexpr int kBox = 3;               // [px] colours are averaged over this square
constexpr int kMostSamples = 200;     // samples of a stroke or of the object
constexpr int kRestSamples = 300;     // samples of the rest of the map
constexpr float kTolerance = 2;       // [grey levels] added to distances, which noise limits
constexpr float kSquaredWidth = 8;    // [grey levels^2] of a sample's kernel
constexpr float kStrokeShare = 0.2F;  // least weight of the whole stroke, per sample of the rest
constexpr float kWeight = 3;          // weight of the densities' log-ratio in the unary term
constexpr float kInside = 4;          // log-odds; pixels inside the map are wrong less often
constexpr float kLargestVote = 10;    // largest log-odds of a vote

// Log-odds that another pixel belongs to the structure that a stroke excludes, by logistic
// regression.
constexpr float kByAppearance = 0.65F;  // per e-fold of distance, of colours and change each
constexpr float kByFewSamples = 0.7F;   // per e-fold: the fewer samples, the farther the nearest
constexpr float kByUnary = -0.17F;
constexpr float kHighestUnary = 15;
constexpr float kLargestLogOdds = 10;  // largest log-odds, so that no pixel is impossible
constexpr float kOutermostBias = -1.1F, kInsideBias = -3.5F;

// Colours of a pixel and their change against the image after.
struct Appearance {
  cv::Vec3f colours, change;
};
using Part = cv::Vec3f Appearance::*;

class AppearanceImages {
 public:
  explicit AppearanceImages(const CutImages& cut) {
    cv::blur(cut.before, colours_, {kBox, kBox});
    cv::blur(cut.before - cut.after, change_, {kBox, kBox});
  }

  Appearance at(const cv::Point& pixel) const {
    return {colours_.at<cv::Vec3f>(pixel), change_.at<cv::Vec3f>(pixel)};
  }

  std::vector<Appearance> at(const std::vector<cv::Point>& pixels) const {
    std::vector<Appearance> appearances;
    for (const auto& pixel : pixels) appearances.push_back(at(pixel));
    return appearances;
  }

 private:
  cv::Mat colours_, change_;  // CV_32FC3
};

// Evenly sampled pixels of `mask`: `most` to twice as many, or all if there are fewer.
std::vector<cv::Point> some_of(const cv::Mat& mask, int most) {
  const int step = std::max(1, cv::countNonZero(mask) / most);
  std::vector<cv::Point> pixels;
  int seen = 0;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask.at<uchar>(y, x) && seen++ % step == 0) pixels.emplace_back(x, y);
  return pixels;
}

// Pixels of `mask` whose unary is at least their median.
cv::Mat surer_half(const cv::Mat& mask, const cv::Mat& unary) {
  std::vector<float> values;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask.at<uchar>(y, x)) values.push_back(unary.at<float>(y, x));
  if (values.empty()) return mask;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return mask & (unary >= *middle);
}

// Pixels that have all four neighbours in the map.
cv::Mat inside_of(const cv::Mat& map) {
  cv::Mat inside;
  cv::erode(map, inside, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}));
  return inside;
}

// Logarithm of the distance to the nearest of `samples`.
float log_distance(const Appearance& appearance, const std::vector<Appearance>& samples,
                   Part part) {
  float least = std::numeric_limits<float>::max();
  for (const auto& sample : samples) {
    const cv::Vec3f apart = appearance.*part - sample.*part;
    least = std::min(least, apart.dot(apart));
  }
  return std::log(std::sqrt(least) + kTolerance);
}

// How much nearer an appearance is to the samples `one` than to `other`, in e-folds of distance.
float nearness(const Appearance& appearance, const std::vector<Appearance>& one,
               const std::vector<Appearance>& other) {
  float sum = 0;
  for (const Part part : {&Appearance::colours, &Appearance::change})
    sum += log_distance(appearance, other, part) - log_distance(appearance, one, part);
  return sum;
}

// Training sample: an appearance with its weights for the excluded structure (`excluded_weight`)
// and for the object.
struct TrainingSample {
  Appearance appearance;
  float excluded_weight = 0, object = 0;
};

// Logarithm of the ratio of the densities of the excluded structure and of the object.
float log_ratio(const Appearance& appearance, const std::vector<TrainingSample>& samples) {
  constexpr float kLeast = 1e-20F;
  float sum = 0;
  for (const Part part : {&Appearance::colours, &Appearance::change}) {
    float excluded_weight = kLeast, object = kLeast;
    for (const auto& sample : samples) {
      const cv::Vec3f apart = appearance.*part - sample.appearance.*part;
      const float inverse = 1 / (kSquaredWidth + apart.dot(apart));
      const float density = inverse * inverse * inverse;
      excluded_weight += sample.excluded_weight * density;
      object += sample.object * density;
    }
    sum += std::log(excluded_weight / object);
  }
  return sum;
}

void normalize(std::vector<TrainingSample>& samples) {
  float excluded_weight = 0, object = 0;
  for (const auto& sample : samples) {
    excluded_weight += sample.excluded_weight;
    object += sample.object;
  }
  for (auto& sample : samples) {
    sample.excluded_weight /= excluded_weight;
    sample.object /= object;
  }
}

// Training samples: the stroke's pixels, and others with their estimated class. At first only the
// more certain half of the others represents the object, because the rest may be wrong for the same
// reason as the excluded pixels.
std::vector<TrainingSample> draw_training_samples(const CutImages& cut,
                                                  const AppearanceImages& appearances,
                                                  const cv::Mat& excluded, const cv::Mat& inside) {
  const cv::Mat rest = cut.map & ~excluded;
  const auto stroke = appearances.at(some_of(excluded, kMostSamples));
  const auto object = appearances.at(some_of(surer_half(rest, cut.unary), kMostSamples));
  if (stroke.empty() || object.empty()) return {};
  const auto pixels = some_of(rest, kRestSamples);
  const float share = static_cast<float>(object.size()) / static_cast<float>(stroke.size());
  std::vector<TrainingSample> samples;
  for (const auto& pixel : pixels) {
    const Appearance appearance = appearances.at(pixel);
    const float unary = std::clamp(cut.unary.at<float>(pixel), -kHighestUnary, kHighestUnary);
    const float log_odds = kByAppearance * nearness(appearance, stroke, object) +
                           kByFewSamples * std::log(share) + kByUnary * unary +
                           (inside.at<uchar>(pixel) ? kInsideBias : kOutermostBias);
    const float excluded_weight =
        1 / (1 + std::exp(-std::clamp(log_odds, -kLargestLogOdds, kLargestLogOdds)));
    samples.push_back({appearance, excluded_weight, (1 - excluded_weight) * (1 - excluded_weight)});
  }
  const float drawn =
      kStrokeShare * static_cast<float>(pixels.size()) / static_cast<float>(stroke.size());
  for (const auto& appearance : stroke) samples.push_back({appearance, std::max(1.F, drawn), 0});
  normalize(samples);
  return samples;
}

}  // namespace

cv::Mat exclusion_votes(const CutImages& cut, const cv::Mat& excluded) {
  cv::Mat votes = cv::Mat::zeros(cut.map.size(), CV_32FC1);
  const AppearanceImages appearances(cut);
  const cv::Mat inside = inside_of(cut.map);
  const auto samples = draw_training_samples(cut, appearances, excluded, inside);
  if (samples.empty()) return votes;
  const cv::Mat rest = cut.map & ~excluded;
  for (int y = 0; y < rest.rows; ++y)
    for (int x = 0; x < rest.cols; ++x) {
      if (!rest.at<uchar>(y, x)) continue;
      const float vote = kWeight * log_ratio(appearances.at(cv::Point(x, y)), samples) -
                         (inside.at<uchar>(y, x) ? kInside : 0);
      votes.at<float>(y, x) = std::clamp(vote, -kLargestVote, kLargestVote);
    }
  return votes;
}

}  // namespace mbncc::segmentation
