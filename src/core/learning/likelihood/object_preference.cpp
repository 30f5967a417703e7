// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/object_preference.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "learning/likelihood/background_likelihood.hpp"
#include "learning/likelihood/line_evidence.hpp"

namespace mbncc {
namespace {

constexpr float kAnyColour = 0.05F;  // part of the object's pixels in colours not seen yet
constexpr float kWeight = 1.15F;     // against the smoothness
constexpr double kSureness = 4;  // power of the change's probability that colours are weighted by
constexpr double kRimWeight = 0.3;  // of the outermost pixels' colours
constexpr float kRimDoubt = 3;      // taken from the pixels on both sides of the last outline
constexpr float kLineWeight = 3;    // of what speaks for a thin part
constexpr float kLineLeast = 0.3F;  // mean along a line from which on it does
constexpr float kGapWeight = 2;     // of what speaks for a narrow gap
constexpr float kGapLeast = 1;      // mean against the object from which on it does

// The pixels on both sides of an outline.
cv::Mat rim_of(const cv::Mat& map) {
  const cv::Mat cross = cv::getStructuringElement(cv::MORPH_CROSS, {3, 3});
  cv::Mat grown, core;
  cv::dilate(map, grown, cross);
  cv::erode(map, core, cross);
  return grown & ~core;
}

}  // namespace

cv::Mat relative_density(const ColourMixture& mixture, const cv::Mat& picture) {
  return mixture.densities(picture) * std::exp(-log_uniform_colour());
}

// Surely changed pixels teach the object's colours. Doubtful ones (its shadow's rim) hardly do, and
// the outermost less, since platform shines through.
cv::Mat colour_weights(const cv::Mat& changed, const cv::Mat& map) {
  cv::Mat sureness, core;
  cv::pow(changed, kSureness, sureness);
  cv::erode(map, core, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}));
  cv::Mat weight = sureness * kRimWeight;
  sureness.copyTo(weight, core);
  return weight;
}

// Blur and pooling carry change over the outline: once there is one, its pixels have to be the
// likelier object's.
cv::Mat object_preference(const cv::Mat& before, const ColourMixture& object,
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

}  // namespace mbncc
