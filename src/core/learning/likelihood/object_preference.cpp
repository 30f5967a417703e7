// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/object_preference.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "learning/likelihood/background_likelihood.hpp"
#include "learning/likelihood/line_evidence.hpp"

namespace mbncc::likelihood {
namespace {

constexpr float kAnyColour = 0.05F;  // part of the object's pixels in colours not seen yet
constexpr float kWeight = 1.15F;     // weight of the unary term relative to the smoothness term
constexpr double kSureness = 4;      // exponent of the probability of change in colour weights
constexpr double kRimWeight = 0.3;   // weight of the outermost pixels' colours
constexpr float kRimDoubt = 3;       // log-odds subtracted on both sides of the last outline
constexpr float kLineWeight = 3;     // weight of the evidence for a thin part
constexpr float kLineLeast = 0.3F;   // least mean along a line for a thin part
constexpr float kGapWeight = 2;      // weight of the evidence for a narrow gap
constexpr float kGapLeast = 1;       // least mean against the object for a narrow gap

// The pixels on both sides of an outline.
cv::Mat rim_of(const cv::Mat& map) {
  const cv::Mat cross = cv::getStructuringElement(cv::MORPH_CROSS, {3, 3});
  cv::Mat grown, core;
  cv::dilate(map, grown, cross);
  cv::erode(map, core, cross);
  return grown & ~core;
}

}  // namespace

cv::Mat relative_density(const change::ColourMixture& mixture, const cv::Mat& image) {
  return mixture.densities(image) * std::exp(-log_uniform_colour());
}

// The object's colours are estimated from certainly changed pixels. Uncertain ones (the rim of a
// shadow) have little weight, and the outermost less, because they mix with the platform.
cv::Mat colour_weights(const cv::Mat& changed, const cv::Mat& map) {
  cv::Mat sureness, core;
  cv::pow(changed, kSureness, sureness);
  cv::erode(map, core, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}));
  cv::Mat weight = sureness * kRimWeight;
  sureness.copyTo(weight, core);
  return weight;
}

// Blur and pooling spread change over the outline, so pixels at a known outline need higher
// log-odds.
cv::Mat object_preference(const cv::Mat& before, const change::ColourMixture& object,
                          const cv::Mat& background, const cv::Mat& last_map) {
  cv::Mat preference;
  cv::log((1 - kAnyColour) * relative_density(object, before) + kAnyColour, preference);
  preference = kWeight * (preference - background);
  const LineEvidence lines = line_evidence(preference);
  preference += kLineWeight * cv::max(lines.parts - kLineLeast, 0);
  preference -= kGapWeight * cv::max(lines.gaps - kGapLeast, 0);
  if (!last_map.empty()) cv::subtract(preference, kRimDoubt, preference, rim_of(last_map));
  return cv::max(cv::min(preference, kHighestPreference), -kHighestPreference);
}

}  // namespace mbncc::likelihood
