// SPDX-License-Identifier: BSD-3-Clause
// Cuts a lesson's object out of its picture: region, segmentation, further cuts with marks.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "learning/teaching/lesson_progress.hpp"
#include "learning/teaching/marks.hpp"
#include "learning/teaching/segmenter.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc {

/// May the region that is cut in grow when the map touches its edge?
enum class Room { kStays, kMayGrow };

/// Steps of one lesson that passed check_lesson(); refers to it, so that it may be pointed at
/// another region meanwhile. Where nothing else is said, throws LessonEnded when there is no map.
class MapCutter {
 public:
  /// `timings_ms` receives "region" and "segment". All must outlive this.
  MapCutter(const Lesson& lesson, const LearningConfig& config, LessonProgress& progress,
            std::map<std::string, double>& timings_ms);

  /// The lesson's map: given ready, or cut out of the lesson's region.
  Segmentation acquire_map();

  /// Finds the region of a lesson that brings no map; what follows is cut in there.
  void mark_region();

  /// From now on the object is searched in `place` [px] alone, wherever something changed there.
  void look_at(const cv::Rect& place);

  Segmentation segment(Room room);

  /// None where segment() says that there is no map; throws LessonEnded(kCancelled) alone.
  std::optional<Segmentation> segment_if_possible(Room room);

  /// `cut` again, holding to the marks.
  Segmentation cut_again(const Segmentation& cut, const Marks& marks);

  const SegmentationTask& task() const { return task_; }
  void set_task(const SegmentationTask& task) { task_ = task; }

  /// All changes, arrivals included: CV_8UC1 of the picture's size; empty without a picture after.
  const cv::Mat& surveyed() const { return surveyed_; }

 private:
  Segmentation accept(const cv::Mat& map);
  Segmentation segment_once();
  Segmentation clicked(const Segmentation& found);
  bool widen(const Segmentation& found);

  const Lesson& lesson_;
  const LearningConfig& config_;
  LessonProgress& progress_;
  std::map<std::string, double>& timings_ms_;
  SegmentationTask task_;
  cv::Mat surveyed_;
};

}  // namespace mbncc
