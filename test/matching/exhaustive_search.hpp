// SPDX-License-Identifier: BSD-3-Clause
// A search that cannot miss: the plain similarity at every position and rotation. Slow; the
// reference that the fast search is tested against.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {

struct ExhaustiveSettings {
  double min_similarity = 0.5;        ///< [-1..1] of a detection
  double angle_step = to_radians(3);  ///< [rad]
  int position_step = 1;              ///< [px]
  double min_visible = 0.5;           ///< [0..1] fraction of the map inside the image
  int max_instances = 10;
  double max_overlap = 0.25;  ///< [0..1] overlap of two maps, as a fraction of the smaller
};

/// Detections of the object's first view, most similar first; score is the similarity. Poses are
/// grid points, so they are off by up to half a step. Fields that need evidence keep their
/// defaults. Throws like Matcher.
std::vector<Match> find_exhaustively(const ObjectModel& object, const cv::Mat& image,
                                     const ExhaustiveSettings& settings = {});

}  // namespace mbncc
