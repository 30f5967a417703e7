// SPDX-License-Identifier: BSD-3-Clause
// A lesson with corrections by the operator: strokes on the object or the background, another
// region, another frame, and undo.
#pragma once

#include <memory>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/lesson.hpp"
#include "mbncc/learning/lesson_edit.hpp"

namespace mbncc {

/// Strokes accumulate over the edits; later ones override earlier ones. Every edit starts from the
/// first cut with all strokes so far, so the same edits give an identical map. If the map or the
/// outline was given, strokes are painted into it.
class InteractiveLesson {
 public:
  /// Learns as learn_object() does. The images of `lesson` are shared, not copied.
  explicit InteractiveLesson(const Lesson& lesson, const LearningConfig& config = {},
                             const SearchConfig& search = {}, const StageObserver& observer = {});
  ~InteractiveLesson();
  InteractiveLesson(InteractiveLesson&&) noexcept;
  InteractiveLesson& operator=(InteractiveLesson&&) noexcept;

  /// Result of the lesson with all edits that were not undone.
  const LearnResult& result() const;

  /// Segments and evaluates again. An edit that fails (strokes outside the image, nothing left of
  /// the object, cancelled, a first lesson without a map) changes nothing; its result gives the
  /// reason.
  LearnResult edit(const LessonEdit& edit, const StageObserver& observer = {});

  /// Undoes the last edit exactly. False if there is none; the last 64 edits are kept.
  bool undo();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mbncc
