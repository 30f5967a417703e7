// SPDX-License-Identifier: BSD-3-Clause
// Input and result of a lesson.
#pragma once

#include <functional>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/error.hpp"
#include "mbncc/learning/cut_evidence.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Input of a lesson. At least one of `map`, `outline`, `click`, `region` and `after` must indicate
/// the object's place.
struct Lesson {
  cv::Mat before;   ///< CV_8UC3, the object lies on the platform
  cv::Mat after;    ///< CV_8UC3 of the same size, the object is gone; may be empty
  cv::Rect region;  ///< [px] approximate region; empty: whole image (needs `after`)
  std::vector<cv::Point2f> outline;  ///< [px] polygon on `before`
  std::optional<cv::Point2f> click;  ///< [px] a point on the object
  cv::Mat map;                       ///< CV_8UC1 of before's size, used unchanged
  std::optional<Pose2D> reference;   ///< [px],[rad] object frame; none: map's centroid, theta 0
  std::string name;
  std::string label;            ///< "" : same as name
  double object_height = 0;     ///< [m]
  std::optional<int> symmetry;  ///< declared, see is_declarable_symmetry(); none: measured
};

/// Steps reported to an observer, in this order.
enum class Stage { kRegion, kSegment, kQuality };

/// Called at each step with the progress in [0..1] and an image of the step (CV_8UC3, may be
/// empty). Returning false ends the lesson with kCancelled within one graph cut.
using StageObserver = std::function<bool(Stage stage, double progress, const std::string& message,
                                         const cv::Mat& image)>;

/// The object where it was put aside, within the view of the image after.
struct PutAside {
  Pose2D pose;           ///< [px],[rad] of the object frame there
  double agreement = 0;  ///< [0..1] IoU of the learned map with the map segmented there
  bool refined = false;  ///< both views contributed to the map
};

struct LearnResult {
  LearnError error = LearnError::kInternal;
  std::string message;                       ///< what happened, one sentence
  std::string hint;                          ///< what to do about it, one sentence
  ObjectModel object;                        ///< as far as computed; complete if `has_model`
  bool has_model = false;                    ///< map, template, reference and quality are filled in
  std::optional<CutEvidence> evidence;       ///< none: the map was given
  std::optional<PutAside> put_aside;         ///< none: out of view, or not recognised
  std::map<std::string, double> timings_ms;  ///< per step, and "total"
};

}  // namespace mbncc
