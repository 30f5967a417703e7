#include "mbncc/matching/overlay.hpp"

#include <cstdio>

namespace mbncc {

Marking marking_of(const Match& match) {
  char score[16];
  std::snprintf(score, sizeof score, " %.2f", match.score);
  Marking marking;
  marking.outlines = {match.outline};
  marking.pose = match.pose;
  marking.caption = match.name + score;
  if (match.ambiguous) {
    marking.colour = colour_of(Standing::kDoubtful);
    marking.caption += " ambiguous";
  } else if (!match.graspable) {
    marking.colour = colour_of(Standing::kUnsure);
    marking.caption += " unsure";
  }
  if (!match.reasons.empty()) marking.caption += "\n" + match.reasons.front();
  return marking;
}

cv::Mat draw_matches(const cv::Mat& picture, const std::vector<Match>& matches) {
  std::vector<Marking> markings;
  for (const auto& match : matches) markings.push_back(marking_of(match));
  return draw_markings(picture, markings);
}

}  // namespace mbncc
