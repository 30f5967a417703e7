// SPDX-License-Identifier: BSD-3-Clause
// One lesson: pictures and a region in, an object model with its verdict out (the paper's learning
// phase).
#pragma once

#include <functional>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/learning/quality.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// What the operator shows. Exactly one way of saying where the object is must be usable:
/// a ready `map`, an `outline`, a `click`, a `region`, or an `after` picture.
struct Lesson {
  cv::Mat before;   ///< CV_8UC3, the object lies on the platform
  cv::Mat after;    ///< CV_8UC3 of the same size, the object is gone; may be empty
  cv::Rect region;  ///< [px] approximate region; empty: whole picture (needs `after`)
  std::vector<cv::Point2f> outline;  ///< [px] polygon on `before`
  std::optional<cv::Point2f> click;  ///< [px] a point on the object
  cv::Mat map;                       ///< CV_8UC1 of before's size, taken as it is
  std::optional<Pose2D> reference;   ///< [px],[rad] object frame; none: centroid of the map, 0
  std::string name;
  std::string label;            ///< "" : same as name
  double object_height = 0;     ///< [m]
  std::optional<int> symmetry;  ///< declared, see is_declarable_symmetry(); none: measured
};

/// Steps that an observer hears of, in this order.
enum class Stage { kRegion, kSegment, kQuality };

/// Called at each step with a progress in [0..1] and a picture of the step (CV_8UC3, may be empty).
/// Returning false ends the lesson with kCancelled; the answer comes within one graph cut.
using StageObserver = std::function<bool(Stage stage, double progress, const std::string& message,
                                         const cv::Mat& picture)>;

/// The object, put aside within the view of the picture after.
struct PutAside {
  Pose2D pose;           ///< [px],[rad] of the object frame there
  double agreement = 0;  ///< [0..1] IoU of the map learned before with the one cut out there
  bool refined = false;  ///< both views made the map
};

struct LearnResult {
  LearnError error = LearnError::kInternal;
  std::string message;                       ///< what happened, one sentence
  std::string hint;                          ///< what to do about it, one sentence
  ObjectModel object;                        ///< as far as it got; complete when `has_model`
  bool has_model = false;                    ///< map, template, reference and quality are filled in
  std::optional<CutEvidence> evidence;       ///< none: the map was given ready
  std::optional<PutAside> put_aside;         ///< none: out of view, or not recognised
  std::map<std::string, double> timings_ms;  ///< per step, and "total"
};

/// Segments the object and judges the result. A verdict BAD gives the error of its worst reason
/// with `has_model` set: the caller decides whether to store it. Nothing is stored here.
LearnResult learn_object(const Lesson& lesson, const LearningConfig& config = {},
                         const SearchConfig& search = {}, const StageObserver& observer = {});

}  // namespace mbncc
