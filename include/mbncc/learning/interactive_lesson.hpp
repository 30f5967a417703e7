// SPDX-License-Identifier: BSD-3-Clause
// A lesson that the operator corrects: strokes that belong to the object or not, another region,
// another frame; and back again.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc {

/// One correction, as in srv/ConfirmLearning.srv. What is not given stays as it was.
struct LessonEdit {
  using Line = std::vector<cv::Point2f>;  ///< [px] in the learning picture

  std::vector<Line> include;        ///< belongs to the object
  std::vector<Line> exclude;        ///< does not; wins where both are drawn
  double stroke_width = 0;          ///< [px] of the lines, at most 1000; 0: closed areas
  cv::Rect region;                  ///< [px] new approximate region; empty: as before
  std::optional<Pose2D> reference;  ///< [px],[rad] object frame
};

/// Strokes add up over the edits; a later one wins over an earlier one. Every edit starts from the
/// first cut and all strokes so far, so the same edits give the same map, bit for bit. Where the
/// map or the outline was given ready, strokes paint on it.
class InteractiveLesson {
 public:
  /// Learns as learn_object() does. The pictures of `lesson` are shared, not copied.
  explicit InteractiveLesson(const Lesson& lesson, const LearningConfig& config = {},
                             const SearchConfig& search = {}, const StageObserver& observer = {});
  ~InteractiveLesson();
  InteractiveLesson(InteractiveLesson&&) noexcept;
  InteractiveLesson& operator=(InteractiveLesson&&) noexcept;

  /// Of the lesson and all edits in force.
  const LearnResult& result() const;

  /// Segments and judges again. An edit that fails (strokes outside the picture, nothing left of
  /// the object, cancelled, a first lesson without a map) changes nothing: its result tells why.
  LearnResult edit(const LessonEdit& edit, const StageObserver& observer = {});

  /// Takes the last edit back, bit for bit. False when there is none; 64 are kept.
  bool undo();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mbncc
