// SPDX-License-Identifier: BSD-3-Clause
// Explanations in sentences and as an image.
#include "mbncc/matching/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "base/number.hpp"
#include "mbncc/drawing.hpp"

namespace mbncc {
namespace {

using Outcome = Explanation::Outcome;

// Number of decimals: two, or as many as distinguish a value from a threshold that it narrowly
// misses.
int digits_telling(double value, double threshold) {
  constexpr int kMost = 15;
  int digits = 2;
  while (digits < kMost && value != threshold && number(value, digits) == number(threshold, digits))
    ++digits;
  return digits;
}

std::string place_of(const Explanation& explanation) {
  return "(" + number(explanation.pose.x, 1) + ", " + number(explanation.pose.y, 1) + "), " +
         number(to_degrees(explanation.pose.theta), 1) + " deg";
}

const Check* failed_to_report(const Explanation& explanation) {
  for (const auto& check : explanation.checks)
    if (check.to_report && !check.passed) return &check;
  return nullptr;
}

std::string verdict_of(const Explanation& explanation) {
  const Check* unreported = failed_to_report(explanation);
  const int digits =
      unreported == nullptr ? 2 : digits_telling(explanation.score, unreported->threshold);
  const std::string head = "'" + explanation.name + "' at " + place_of(explanation) + ", score " +
                           number(explanation.score, digits) + ": ";
  switch (explanation.outcome) {
    case Outcome::kGraspable:
      return head + "found, and may be grasped.";
    case Outcome::kReported:
      return head + "found, but must not be grasped: " +
             (explanation.reasons.empty() ? "" : explanation.reasons.front()) + ".";
    case Outcome::kRejected:
      if (!explanation.covered_by.empty())
        return head + "not reported, since '" + explanation.covered_by + "' takes the place.";
      if (unreported != nullptr)
        return head + "not reported, since the score is below min_score " +
               number(unreported->threshold, digits) + ".";
      return head + "not reported, since better ones reach max_instances or overlap it.";
    default:
      return head + "not found: the search proposed no pose at this place" +
             (explanation.covered_by.empty() ? "."
                                             : ", which '" + explanation.covered_by + "' takes.");
  }
}

std::string evidence_of(const Explanation& explanation) {
  std::string text = "Parts of the score:";
  auto parts = explanation.parts;
  std::stable_sort(parts.begin(), parts.end(),
                   [](const ScorePart& a, const ScorePart& b) { return a.lacking > b.lacking; });
  for (const auto& part : parts)
    text += (&part == &parts.front() ? " " : "; ") + part.name + " " + number(part.value, 2) +
            " (lacks " + number(part.lacking, 1) + ")";
  return text + ".";
}

std::string sum_of(const Explanation& explanation) {
  const LogOdds& odds = explanation.odds;
  return "Log-odds: evidence " + number(odds.evidence, 1) + ", colours of parts " +
         number(-odds.colour, 1) + ", mirror image " + number(-odds.mirror, 1) + ", print " +
         number(-odds.print, 1) + ", other angles " + number(odds.rotations(), 1) +
         ", look-alikes elsewhere " + number(-odds.clutter, 1) + ", calibration " +
         number(odds.calibration, 1) + "; together " + number(odds.total(), 1) + ".";
}

std::string checks_of(const Explanation& explanation) {
  std::string text = "Thresholds:";
  for (const auto& check : explanation.checks) {
    const int digits = digits_telling(check.value, check.threshold);
    text += (&check == &explanation.checks.front() ? " " : "; ") + check.name + " " +
            number(check.threshold, digits) + " " + (check.passed ? "passed" : "FAILED") +
            " with " + number(check.value, digits);
  }
  return text + ".";
}

std::string competitor_of(const Explanation& explanation, const Competitor& competitor) {
  return "Competitor: '" + competitor.name + "' at (" + number(competitor.position.x, 0) + ", " +
         number(competitor.position.y, 0) + "), " +
         number(explanation.odds.total() - competitor.log_odds, 1) + " log-odds behind.";
}

std::string advice_on(const Explanation& explanation) {
  if (explanation.outcome == Outcome::kGraspable) return "Nothing to do.";
  if (explanation.outcome == Outcome::kReported)
    return "Remove the cause of this reason, or teach a further view in this position.";
  if (!explanation.covered_by.empty())
    return "Teach both where they differ, or disable the one that is not used.";
  const auto worst = std::max_element(
      explanation.parts.begin(), explanation.parts.end(),
      [](const ScorePart& a, const ScorePart& b) { return a.lacking < b.lacking; });
  const std::string most =
      worst == explanation.parts.end() ? "" : " Most is lacking in: " + worst->name + ".";
  return "If the object lies here with the taught side up, teach a further view in this position, "
         "or improve the light; another side is taught under its own name." +
         most;
}

Marking marking_of(const Explanation& explanation) {
  Marking marking;
  marking.outlines = {explanation.outline};
  marking.pose = explanation.pose;
  const bool found = explanation.outcome == Outcome::kGraspable;
  const bool reported = explanation.outcome == Outcome::kReported;
  marking.colour = colour_of(found      ? Confidence::kGood
                             : reported ? Confidence::kDoubtful
                                        : Confidence::kBad);
  marking.caption = explanation.name + " " + number(explanation.score, 2) +
                    (found      ? ""
                     : reported ? " not graspable"
                                : " not found");
  return marking;
}

}  // namespace

std::vector<std::string> lines_of(const Explanation& explanation) {
  if (explanation.outline.empty())
    return {"'" + explanation.name + "': nothing similar is visible at this place.",
            "Point at the middle of the object, or teach a further view in this position."};
  std::vector<std::string> lines{verdict_of(explanation)};
  if (!explanation.parts.empty()) {
    lines.push_back(evidence_of(explanation));
    lines.push_back(sum_of(explanation));
  }
  if (!explanation.checks.empty()) lines.push_back(checks_of(explanation));
  for (const auto& competitor : explanation.competitors)
    lines.push_back(competitor_of(explanation, competitor));
  for (std::size_t i = 0; i < explanation.reasons.size(); ++i)
    lines.push_back("Against grasping: " + explanation.reasons[i] + ".");
  lines.push_back(advice_on(explanation));
  return lines;
}

cv::Mat draw_explanation(const cv::Mat& image, cv::Point2d place,
                         const std::vector<Explanation>& explanations) {
  std::vector<Marking> markings;
  if (!explanations.empty() && !explanations.front().outline.empty())
    markings.push_back(marking_of(explanations.front()));
  cv::Mat drawn = draw_markings(image, markings);
  const int arm = std::max(6, drawn.cols / 60), stroke = drawn.cols / 640 + 1;
  const cv::Scalar ink(255, 255, 255), shade(0, 0, 0);
  for (const auto& [colour, width] : {std::pair{shade, stroke + 2}, std::pair{ink, stroke}})
    cv::drawMarker(drawn, place, colour, cv::MARKER_CROSS, 2 * arm, width, cv::LINE_AA);
  if (explanations.empty()) return drawn;
  for (const auto& competitor : explanations.front().competitors) {
    cv::circle(drawn, competitor.position, arm, colour_of(Confidence::kDoubtful), stroke + 1,
               cv::LINE_AA);
  }
  return drawn;
}

}  // namespace mbncc
