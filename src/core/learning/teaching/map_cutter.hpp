// SPDX-License-Identifier: BSD-3-Clause
// Segments a lesson's object: region, segmentation, further cuts with strokes.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "learning/teaching/lesson_progress.hpp"
#include "learning/teaching/marks.hpp"
#include "learning/teaching/segmenter.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/learning/lesson.hpp"

namespace mbncc::teaching {

/// Whether the region may grow if the map touches its edge.
enum class Growth { kFixed, kMayGrow };

/// Steps of one lesson that passed check_lesson(). Keeps a reference to the lesson, whose region
/// may change. Throws LessonEnded if there is no map, unless stated otherwise.
class MapCutter {
 public:
  /// `timings_ms` receives "region" and "segment". All arguments must outlive the cutter.
  MapCutter(const Lesson& lesson, const LearningConfig& config, LessonProgress& progress,
            std::map<std::string, double>& timings_ms);

  /// The lesson's map: given, or segmented in the lesson's region.
  Segmentation acquire_map();

  /// Finds the region of a lesson without a given map, for the following cuts.
  void mark_region();

  /// Restricts the following cuts to `place` [px], where something changed.
  void set_place(const cv::Rect& place);

  Segmentation segment(Growth growth);

  /// None if segment() reports that there is no map; throws only LessonEnded(kCancelled).
  std::optional<Segmentation> segment_if_possible(Growth growth);

  /// Cuts again from `cut`, with the strokes as constraints.
  Segmentation cut_again(const Segmentation& cut, const Marks& marks);

  const SegmentationTask& task() const { return task_; }
  void set_task(const SegmentationTask& task) { task_ = task; }

  /// All changes, arrivals included: CV_8UC1 of the image's size; empty without an image after.
  const cv::Mat& surveyed() const { return task_.changed; }
  /// Where something may have left, as in RegionOfLesson.
  const cv::Mat& departed() const { return departed_; }
  double second_departure() const { return second_departure_; }  ///< as in RegionOfLesson

 private:
  Segmentation accept(const cv::Mat& map);
  Segmentation segment_once();
  Segmentation segment_unless_touching(double largest_touch);
  Segmentation checked(const Segmentation& found);
  Segmentation segment_region(Growth growth);
  Segmentation segment_drawn_region(const cv::Rect& wider);
  Segmentation segment_clicked(Growth growth);
  Segmentation segment_clicked_change(Growth growth);
  Segmentation find_clicked(Growth growth);
  std::optional<Segmentation> segment_square();
  Segmentation segment_clicked_piece();
  Segmentation clicked(const Segmentation& found);
  Segmentation with_clicked_hole(const Segmentation& found);
  cv::Rect widest_region() const;
  cv::Rect wider_region() const;

  const Lesson& lesson_;
  const LearningConfig& config_;
  LessonProgress& progress_;
  std::map<std::string, double>& timings_ms_;
  SegmentationTask task_;
  cv::Mat departed_;
  double agreement_ = 1, second_departure_ = 0;  // as in RegionOfLesson
};

}  // namespace mbncc::teaching
