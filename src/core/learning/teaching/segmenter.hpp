// SPDX-License-Identifier: BSD-3-Clause
// Common interface of all segmentation methods.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "learning/teaching/lesson_progress.hpp"
#include "learning/teaching/marks.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/learning/cut_evidence.hpp"

namespace mbncc::teaching {

/// Input of a segmenter. All images have one size, the region lies inside.
struct SegmentationTask {
  cv::Mat before;       ///< CV_8UC3
  cv::Mat after;        ///< CV_8UC3, or empty
  cv::Rect region;      ///< [px] the object lies in here
  cv::Mat approximate;  ///< CV_8UC1, 255 on the paper's approximate region
  cv::Mat changed;      ///< CV_8UC1, 255 where the images differ anywhere; empty without `after`
  /// Part [0..1] of a map's outline on the region's edge above which the caller cuts again, in
  /// another region or for the final map.
  double largest_touch = 1;
  /// Part of the region's width and height [0..1] that the object probably fills; 0: unknown.
  double least_span = 0;
};

struct Segmentation {
  cv::Mat map;                          ///< CV_8UC1 of the image's size, 0/255; may be all 0
  std::optional<CutEvidence> evidence;  ///< reliability measures of the cut, if available
  /// A further cut with strokes of the image's size as constraints; none if the map was given.
  std::function<Segmentation(const Marks& marks)> cut_again;
  /// A further cut that adds another view's log-odds per pixel, as in ObjectCut; none for other
  /// methods.
  std::function<Segmentation(const cv::Mat& preference)> cut_with;
};

using Segmenter =
    std::function<Segmentation(const SegmentationTask&, const LearningConfig&, LessonProgress&)>;

/// `method` as in LearningConfig; "auto" depends on the task having an `after` image.
/// Throws std::invalid_argument for an unknown method.
Segmenter segmenter_of(const std::string& method, bool has_after);

}  // namespace mbncc::teaching
