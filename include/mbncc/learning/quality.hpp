// SPDX-License-Identifier: BSD-3-Clause
// The verdict on a lesson: how good are map and template, and will the object be found again?
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// What a cut knows about its own reliability.
struct CutEvidence {
  double region_touch = 0;    ///< [0..1] part of the outline that lies on the region's edge
  double region_span = 1;     ///< [0..1] the map's box against the region's, in the worse direction
  double change_outside = 0;  ///< [0..1] changed part of the strip around the region
  double change_beside = 0;   ///< [map's area] sure change in the region that is not the map's
  double stability = 1;       ///< [0..1] least IoU with cuts whose balance was shifted
  double boundary_contrast =
      1;  ///< [0..1] how strong the picture edges are that the outline follows
  bool verified =
      true;  ///< false: cut from one picture's colours, and nothing speaks for or against
};

/// Judges `object` (one view, no quality yet) against its learning picture `before`, in which it is
/// searched to learn how distinct it is. `changed` (CV_8UC1 of the same size, as by
/// survey_change()) is empty where there was no picture after. Reasons are ordered worst first.
Quality assess_quality(const ObjectModel& object, const cv::Mat& before, const cv::Mat& changed,
                       const std::optional<CutEvidence>& evidence, const LearningConfig& config,
                       const SearchConfig& search);

/// Error code of a BAD verdict: that of its worst reason, kQualityBad for a reason without a code.
LearnError error_of(const Quality& quality);

}  // namespace mbncc
