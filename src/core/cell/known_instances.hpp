// The instances that a watched picture is known to show.
#pragma once

#include <limits>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {

struct Known {
  Match match;
  /// Margins of the last search of the whole picture for this object, and of the searches for other
  /// objects at this place; none yet: no margin at all, and no competitor.
  double margin_elsewhere = -std::numeric_limits<double>::infinity();
  double margin_to_others = std::numeric_limits<double>::infinity();
  int looks = 1;  ///< searches since its pixels changed last

  cv::Rect box() const;  ///< [px] about its outline
};

/// Overlap of the outlines' areas as part of the smaller one [0..1].
double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b);

/// Of the same object and near enough to be the same instance, `reach` [px] apart at most.
bool is_continued(const Match& before, const Match& now, double reach);

/// The continued one nearest to `now`; null: none.
const Known* predecessor(const std::vector<Known>& before, const Match& now, double reach);

}  // namespace mbncc
