// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/overlay.hpp"

#include <algorithm>
#include <cstdio>

namespace mbncc {

std::string brief_reason(const std::vector<std::string>& reasons) {
  if (reasons.empty()) return "";
  const std::string& first = reasons.front();
  return "\n" + first.substr(0, std::min(first.find(" at "), first.find(" (")));
}

Marking marking_of(const Match& match) {
  char score[16];
  std::snprintf(score, sizeof score, " %.2f", match.score);
  Marking marking;
  marking.outlines = {match.outline};
  marking.pose = match.pose;
  marking.caption = match.name + score;
  if (match.ambiguous) {
    marking.colour = colour_of(Confidence::kDoubtful);
    marking.caption += " ambiguous" + brief_reason(match.reasons);
  } else if (!match.graspable) {
    marking.colour = colour_of(Confidence::kUnsure);
    marking.caption += " unsure";
  }
  return marking;
}

cv::Mat draw_matches(const cv::Mat& image, const std::vector<Match>& matches) {
  std::vector<Marking> markings;
  for (const auto& match : matches) markings.push_back(marking_of(match));
  return draw_markings(image, markings);
}

}  // namespace mbncc
