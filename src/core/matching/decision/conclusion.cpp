// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/conclusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number.hpp"
#include "matching/decision/margins.hpp"

namespace mbncc::decision {
namespace {

constexpr double kForeignColour = 0.25;  // largest chroma difference of a part
constexpr double kOtherPrint = 0.15;     // largest PrintDifference
constexpr double kOtherEdges = 1.2;      // largest InteriorEdges::difference()
constexpr double kOtherDetail = 1.5;     // largest PrintComparison::difference_in_detail()
constexpr double kMissing = 0.2;         // largest MissingContrast
constexpr double kContradicts = 0.05;    // [agreement] largest advantage of a nearby place
constexpr double kConvincing = 4;        // least calibrated log-odds

/// [px] Standard deviation of the position in the direction in which it is largest: the square root
/// of the larger eigenvalue of the covariance. NaN if a variance is negative.
double place_deviation(const cv::Matx33d& c) {
  if (c(0, 0) < 0 || c(1, 1) < 0) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt((c(0, 0) + c(1, 1)) / 2 + std::hypot((c(0, 0) - c(1, 1)) / 2, c(0, 1)));
}

/// Checks the accuracy of the pose; the angle of a round object is ignored.
void doubt_deviations(const Match& match, const cv::Matx33d& c, const SearchConfig& config,
                      std::vector<Doubt>& doubts) {
  const double place = place_deviation(c);
  const double angle = match.symmetry == 0 ? 0 : to_degrees(std::sqrt(c(2, 2)));
  if (!(place <= config.max_place_deviation))
    doubts.push_back({false, "position known to " + number(place, 1) + " px only"});
  if (!(angle <= config.max_angle_deviation))
    doubts.push_back({false, "angle known to " + number(angle, 1) + " degrees only"});
}

std::string text_of(const Competitor& competitor, double margin) {
  return "competitor " + competitor.name + " at " + number(competitor.position.x, 0) + ", " +
         number(competitor.position.y, 0) + " (margin " + number(margin, 1) + ")";
}

std::string other_angle_of(const Match& match) {
  if (!match.other_angle) return "";
  return " to " + number(to_degrees(wrap_angle(*match.other_angle)), 0) + " degrees";
}

/// The competitor with the highest log-odds; null: none.
const Competitor* best_of(const std::vector<Competitor>& competitors) {
  const auto best = std::max_element(
      competitors.begin(), competitors.end(),
      [](const Competitor& a, const Competitor& b) { return a.log_odds < b.log_odds; });
  return best == competitors.end() ? nullptr : &*best;
}

}  // namespace

std::vector<Doubt> doubts_about(const Match& match, const Detection& detection,
                                const cv::Matx33d& grasp_covariance, const SearchConfig& config) {
  // Negated comparisons, so that NaN counts as a reason.
  std::vector<Doubt> doubts;
  if (!(match.margin_angle >= config.min_margin_angle))
    doubts.push_back({true, "angle open (margin " + number(match.margin_angle, 1) +
                                other_angle_of(match) + ")"});
  if (!(detection.colour_difference <= kForeignColour))
    doubts.push_back({true, "colour of a part differs"});
  if (detection.mirror_alternative) doubts.push_back({true, "mirrored fits as well"});
  if (!(detection.continued <= kMissing)) doubts.push_back({true, "part of something larger"});
  if (!(detection.absent <= kMissing)) doubts.push_back({true, "a part is absent"});
  if (detection.torn) doubts.push_back({false, "upper and lower part lie apart"});
  if (detection.size_alternative) doubts.push_back({true, "another size fits better"});
  if (!(match.score >= config.confirm_score))
    doubts.push_back({false, "score " + number(match.score, 2) + " is below confirm_score"});
  if (detection.contour_alternative >= kNotExamined) {
    doubts.push_back({false, "too unlikely to be examined"});
  } else {
    if (!(detection.contour_alternative <= kContradicts))
      doubts.push_back({false, "outline fits better beside it"});
    if (!(detection.print_difference <= kOtherPrint && detection.edge_difference <= kOtherEdges &&
          detection.detail_difference <= kOtherDetail))
      doubts.push_back({true, "print inside the outline differs"});
  }
  if (config.engine == "polar") doubts.push_back({false, "engine polar compares no other angles"});
  if (!(detection.odds.total() >= kConvincing)) doubts.push_back({false, "evidence too weak"});
  doubt_deviations(match, grasp_covariance, config, doubts);
  if (!(match.visible >= config.min_visible))
    doubts.push_back({false, number(100 * (1 - match.visible), 0) + " % outside"});
  return doubts;
}

void conclude(Match& match, const SearchConfig& config) {
  const Competitor* best = best_of(match.competitors);
  const double margin = best ? match.log_odds() - best->log_odds : kNoCompetitor;
  match.margin_place = margin > kNoCompetitor ? kNoCompetitor : margin;
  bool ambiguous = !(match.margin_place >= config.min_margin_place);
  match.reasons.clear();
  if (ambiguous)
    match.reasons.push_back(best ? text_of(*best, match.margin_place)
                                 : "min_margin_place is above the largest margin");
  for (const auto& doubt : match.doubts) {
    ambiguous |= doubt.ambiguous;
    match.reasons.push_back(doubt.text);
  }
  match.graspable = match.reasons.empty();
  match.ambiguous = ambiguous && match.score >= config.confirm_score;
}

}  // namespace mbncc::decision
