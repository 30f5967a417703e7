// SPDX-License-Identifier: BSD-3-Clause
#include "learning/quality/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace mbncc::quality {
namespace {

// Part of the object's own score above which something else looks the same.
constexpr double kAlike = 0.7;
constexpr double kPlain = 6;        // [grey levels] a plain surface deviates less under the map
constexpr double kCrossing = 0.05;  // [0..1] part of the outline on the region's edge
constexpr double kLargeHole = 0.1;  // [0..1] part of the map with its holes filled
constexpr double kHugeHole = 0.4;   // if it belongs to the object, the map has an IoU below .6
constexpr double kNever = std::numeric_limits<double>::infinity();  // a limit that is never passed

// Reasons against a lesson.
struct Reason {
  const char* key;
  const char* advice;
};

// Worst first.
constexpr std::array<Reason, 19> kReasons{{
    {"touches_image_border", "Move the object fully into view and teach again."},
    {"too_small", "Move the camera closer or use a higher resolution."},
    {"low_texture", "Turn the object's marked side up or improve the light."},
    {"not_found_again", "Turn the object's marked side up, or teach it on a plainer background."},
    {"not_distinct",
     "Something else in the image looks the same and will also be found: take it away if it "
     "is another object."},
    {"touches_region_edge", "Draw a larger region, with platform on every side of the object."},
    {"change_outside_region",
     "Move only this object between the images, and keep arm and hands out of both."},
    {"change_left_out",
     "Check whether a part of the object is missing in the map, or something else moved beside "
     "it."},
    {"unconfirmed_hole",
     "Mark the hole by a stroke, as a part of the object or as platform: the images do not show "
     "which."},
    {"edges_after",
     "Something lies at the object's old place in the image after, or the images are "
     "interchanged: clear the place, and give the image with the object first."},
    {"several_left", "More than one object may have left: click on the one that is meant."},
    {"unstable_cut", "Check the outline and correct it by a stroke: a part of it is uncertain."},
    {"weak_boundary",
     "Check the outline where the object looks like the background, and correct it by a stroke."},
    {"shadow_like",
     "The object is as grey as a shadow of the platform: check the outline, or teach it on a "
     "platform of another colour."},
    {"little_of_region",
     "The map fills little of the region: draw the region close around the object, or draw its "
     "outline."},
    {"unverified_cut",
     "Check the outline: one image alone cannot confirm it. If possible, teach by change."},
    {"round", "All angles count as equal: any of them may be reported."},
    {"symmetric", "Angles a part of a turn apart count as equal: any of them may be reported."},
    {"", ""},
}};

const Reason& reason_of(const std::string& key) {
  // Keys may carry a number: symmetric_180.
  const auto found = std::find_if(kReasons.begin(), kReasons.end(), [&key](const Reason& reason) {
    return key.compare(0, std::strlen(reason.key), reason.key) == 0;
  });
  return found == kReasons.end() ? kReasons.back() : *found;
}

// Collects reasons; the worst one determines the verdict.
class ReasonCollector {
 public:
  explicit ReasonCollector(Quality& quality) : quality_(quality) {}

  // Adds the reason if `value` is beyond a limit: beyond `bad` it refuses, beyond `marginal` it
  // warns.
  void above(const char* key, double value, double marginal, double bad) {
    if (value > bad)
      add(key, Verdict::kBad);
    else if (value > marginal)
      add(key, Verdict::kMarginal);
  }
  void below(const char* key, double value, double marginal, double bad) {
    above(key, -value, -marginal, -bad);
  }
  // A remark that is not a fault.
  void note(const std::string& key) {
    quality_.reasons.push_back(key);
    quality_.advice.push_back(reason_of(key).advice);
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

// Limits of the risk that the outline is wrong.
constexpr double kGoodRisk = 0.2;
constexpr double kBadRisk = 0.5;

// Risk that the map's IoU with the object's silhouette is below .8: logistic regressions, one for
// lessons by change and one for one image, fitted to synthetic (drawn) lessons, to synthetic
// lessons with the faults of real cameras, and to lessons from photographs
// (docs/decisions/0011-verdict.md).
struct OutlineRisk {
  double usual, instability, weakness, change, span;  // log-odds

  static OutlineRisk by_change(const CutEvidence& evidence, double edge_agreement) {
    return {
        -2.5, 7.7 * (1 - evidence.stability),
        1.75 * (1 - evidence.boundary_contrast) + 2.4 * (1 - edge_agreement),
        1.6 * std::min(evidence.change_outside, 0.3) + 0.9 * std::min(evidence.change_beside, 0.5),
        0};
  }

  static OutlineRisk of_one_image(const CutEvidence& evidence, double edge_agreement) {
    return {-2.2, 3.1 * (1 - evidence.stability), 4.2 * (1 - edge_agreement), 0,
            2.5 * (1 - evidence.region_span)};
  }

  double probability() const {
    return 1 / (1 + std::exp(-usual - instability - weakness - change - span));
  }

  // The measure that deviates most from a typical good lesson.
  const char* dominant_reason() const {
    const double unstable = instability - 0.5, weak = weakness - 0.5, underfilled = span - 0.7;
    if (unstable >= weak && unstable >= underfilled) return "unstable_cut";
    return weak >= underfilled ? "weak_boundary" : "little_of_region";
  }
};

void weigh_evidence(const CutEvidence& evidence, Quality& quality, ReasonCollector& reasons) {
  reasons.above("touches_region_edge", evidence.cut_off, 0.03, kNever);
  reasons.above("change_outside_region", evidence.change_outside, 0.1, 0.5);
  reasons.above("change_left_out", evidence.change_beside, 0.08, kNever);
  reasons.above("unconfirmed_hole", evidence.unconfirmed_hole, kLargeHole, kHugeHole);
  reasons.above("edges_after", evidence.edges_after, 0.2, kNever);
  reasons.above("several_left", evidence.second_departure, 0.5, kNever);
  const OutlineRisk risk = evidence.verified
                               ? OutlineRisk::by_change(evidence, quality.edge_agreement)
                               : OutlineRisk::of_one_image(evidence, quality.edge_agreement);
  quality.outline_probability = 1 - risk.probability();
  reasons.above(risk.dominant_reason(), risk.probability(), kGoodRisk, kBadRisk);
  // If the map crosses the region's edge, it is unknown where a shadow would end; an object lies
  // inside the region.
  const bool crosses = evidence.region_touch > kCrossing;
  reasons.above("shadow_like", evidence.shadow_like ? (crosses ? 2 : 1) : 0, 0.5, 1.5);
  reasons.above("unverified_cut", evidence.verified ? 0 : 1, 0.5, 1);
}

// A plain surface is no fault while the outline is enough to find the object. Other things that
// look the same will be found as well, but this is not a fault of the map.
void weigh_search(const Quality& quality, const SearchConfig& search, ReasonCollector& reasons) {
  reasons.below(quality.contrast < kPlain ? "low_texture" : "not_found_again", quality.self_score,
                search.confirm_score, search.min_score);
  if (quality.runner_up > kAlike * quality.self_score) reasons.note("not_distinct");
}

void note_symmetry(int symmetry, ReasonCollector& reasons) {
  if (symmetry == 0) reasons.note("round");
  if (symmetry > 1) reasons.note("symmetric_" + std::to_string(360 / symmetry));
}

}  // namespace

void decide(Quality& quality, bool touches_border, const std::optional<CutEvidence>& evidence,
            const LearningConfig& config, const SearchConfig& search) {
  quality.verdict = Verdict::kGood;
  ReasonCollector reasons(quality);
  reasons.above("touches_image_border", touches_border ? 1 : 0, 0.5, 0.5);
  reasons.below("too_small", quality.area, 2 * config.min_area, config.min_area);
  weigh_search(quality, search, reasons);
  if (evidence) weigh_evidence(*evidence, quality, reasons);
  note_symmetry(quality.symmetry, reasons);
}

}  // namespace mbncc::quality
