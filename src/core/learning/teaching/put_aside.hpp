// SPDX-License-Identifier: BSD-3-Clause
// Finds the object in the image after if it was put aside within the view.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "learning/teaching/segmenter.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::teaching {

struct NewPlace {
  Pose2D motion;         ///< [px],[rad] transforms points of the object from before to after
  double agreement = 0;  ///< [0..1] IoU of the learned map there with a map segmented there
  cv::Mat preference;    ///< CV_32FC1, log-odds of the cut there, warped onto the image before
};

/// Searches the other changes for the object just learned (one view, with its `map` of the image's
/// size). `changed` is ChangeSurvey::changed, including arrivals. None if the object is not found.
std::optional<NewPlace> find_put_aside(const ObjectModel& object, const cv::Mat& map,
                                       const SegmentationTask& task, const cv::Mat& changed,
                                       const LearningConfig& config, const SearchConfig& search);

/// Other places [px] of `changed` that the object may have left, if it did not leave from `map`:
/// the few largest ones that do not touch the map.
std::vector<cv::Rect> places_elsewhere(const cv::Mat& changed, const cv::Mat& map);

/// Boxes [px] of a few large connected parts of a map, with little margin; none if it has only one.
/// Each may be a separate place.
std::vector<cv::Rect> large_parts(const cv::Mat& map);

}  // namespace mbncc::teaching
