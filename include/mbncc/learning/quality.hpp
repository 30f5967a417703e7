// SPDX-License-Identifier: BSD-3-Clause
// The verdict on a lesson: quality of map and template, and whether the object is found again.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Measures of a cut's reliability.
struct CutEvidence {
  double region_touch = 0;  ///< [0..1] part of the outline that lies on the region's edge
  double cut_off =
      0;  ///< [0..1] part of the outline beside an intruder, or beside change outside the region
  double region_span =
      1;  ///< [0..1] extent of the map's box relative to the region's, in the worse direction
  double change_outside = 0;  ///< [0..1] changed part of the strip around the region
  double change_beside = 0;   ///< [map's area] certain change in the region outside the map
  double stability =
      1;  ///< [0..1] least IoU with cuts of shifted balance; of one picture: with the other method
  double boundary_contrast = 1;  ///< [0..1] strength of the picture edges along the outline
  bool shadow_like = false;      ///< a shadow of the platform would look like the object
  bool verified = true;  ///< false: cut from one picture, without confirmation by a second one
};

/// Evaluates `object` (one view, no quality yet) in its learning picture `before`, in which it is
/// also searched to measure how distinct it is. `changed` (CV_8UC1 of the same size, from
/// survey_change()) is empty if there was no picture after. Reasons are ordered worst first.
Quality assess_quality(const ObjectModel& object, const cv::Mat& before, const cv::Mat& changed,
                       const std::optional<CutEvidence>& evidence, const LearningConfig& config,
                       const SearchConfig& search);

/// Error code of a BAD verdict: the code of its worst reason, kQualityBad if the reason has none.
LearnError error_of(const Quality& quality);

}  // namespace mbncc
