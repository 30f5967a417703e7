// SPDX-License-Identifier: BSD-3-Clause
// The verdict on a lesson: quality of map and template, and whether the object is found again.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/cut_evidence.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Evaluates `object` (one view, no quality yet) in its learning image `before`, in which it is
/// also searched to measure how distinct it is. `changed` (CV_8UC1 of the same size, from
/// survey_change()) is empty if there was no image after. Reasons are ordered worst first.
Quality assess_quality(const ObjectModel& object, const cv::Mat& before, const cv::Mat& changed,
                       const std::optional<CutEvidence>& evidence, const LearningConfig& config,
                       const SearchConfig& search);

}  // namespace mbncc
