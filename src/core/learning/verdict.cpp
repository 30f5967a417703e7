#include "learning/verdict.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace mbncc {
namespace {

// What can be said against a lesson. A key may have a code of its own for the action's result.
struct Reason {
  const char* key;
  LearnError error;
  const char* advice;
};

// Worst first.
constexpr std::array<Reason, 10> kReasons{{
    {"touches_image_border", LearnError::kTouchesBorder,
     "Put the object wholly into the picture and teach again."},
    {"too_small", LearnError::kTooSmall, "Bring the camera nearer or use a higher resolution."},
    {"low_texture", LearnError::kLowTexture,
     "Turn the object's marked side up or improve the light."},
    {"touches_region_edge", LearnError::kQualityBad,
     "Draw the region larger, with platform on every side of the object."},
    {"change_outside_region", LearnError::kQualityBad,
     "Move only this object between the pictures, and keep arm and hands out of both."},
    {"unstable_cut", LearnError::kQualityBad,
     "Put the object on a background of another colour, or check the map's outline."},
    {"weak_boundary", LearnError::kQualityBad,
     "Put the object on a background that contrasts with it."},
    {"looks_like_shadow", LearnError::kQualityBad,
     "Use softer light, or check that no shadow was taken into the map."},
    {"ambiguous_pixels", LearnError::kQualityBad,
     "Put the object on a background of another colour."},
    {"", LearnError::kQualityBad, ""},
}};

const Reason& reason_of(const std::string& key) {
  const auto found = std::find_if(kReasons.begin(), kReasons.end(),
                                  [&key](const Reason& reason) { return key == reason.key; });
  return found == kReasons.end() ? kReasons.back() : *found;
}

// Collects reasons; the verdict is that of the worst.
class Charges {
 public:
  explicit Charges(Quality& quality) : quality_(quality) {}

  // Adds the reason when `value` is beyond a limit: at `bad` it refuses, at `marginal` it warns.
  void above(const char* key, double value, double marginal, double bad) {
    if (value > bad)
      add(key, Verdict::kBad);
    else if (value > marginal)
      add(key, Verdict::kMarginal);
  }
  void below(const char* key, double value, double marginal, double bad) {
    above(key, -value, -marginal, -bad);
  }

 private:
  void add(const char* key, Verdict verdict) {
    // A refusing reason goes before the warnings that were found earlier.
    const bool first_bad = verdict > quality_.verdict;
    const auto at = first_bad ? 0 : static_cast<std::ptrdiff_t>(quality_.reasons.size());
    quality_.reasons.insert(quality_.reasons.begin() + at, key);
    quality_.advice.insert(quality_.advice.begin() + at, reason_of(key).advice);
    quality_.verdict = std::max(quality_.verdict, verdict);
  }

  Quality& quality_;
};

void weigh_evidence(const CutEvidence& evidence, Charges& charges) {
  charges.above("touches_region_edge", evidence.region_touch, 0.04, 0.25);
  charges.above("change_outside_region", evidence.change_outside, 0.1, 0.5);
  charges.below("unstable_cut", evidence.stability, 0.6, 0.3);
  charges.below("weak_boundary", evidence.boundary_contrast, 0.35, 0.1);
  charges.above("looks_like_shadow", evidence.shadow_fraction, 0.5, 1);
}

}  // namespace

void decide(Quality& quality, bool touches_border, const std::optional<CutEvidence>& evidence,
            const LearningConfig& config) {
  quality.verdict = Verdict::kGood;
  Charges charges(quality);
  charges.above("touches_image_border", touches_border ? 1 : 0, 0.5, 0.5);
  charges.below("too_small", quality.area, 2 * config.min_area, config.min_area);
  charges.below("low_texture", quality.contrast, 6, 2);
  if (evidence) weigh_evidence(*evidence, charges);
}

LearnError error_of(const Quality& quality) {
  if (quality.verdict != Verdict::kBad) return LearnError::kSuccess;
  return reason_of(quality.reasons.front()).error;
}

}  // namespace mbncc
