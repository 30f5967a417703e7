// SPDX-License-Identifier: BSD-3-Clause
// The object that a lesson has learned so far. It is compared with the library, shown to the
// operator, and corrected by edits.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnObjectResult.h>

#include <optional>
#include <string>

#include "mbncc/learning/interactive_lesson.hpp"
#include "nodelets/learning/lesson_feedback.hpp"
#include "nodelets/learning/lesson_images.hpp"
#include "nodelets/learning/lesson_tools.hpp"

namespace mbncc::nodelets {

/// The lesson of a goal; on failure, `fault` contains the result for the client.
struct GoalLesson {
  Lesson lesson;
  std::optional<mbncc_vision::LearnObjectResult> fault;
};
/// Converts a goal that passed check_goal() to a lesson with these images (CV_8UC3; `after` is
/// empty if the mode needs none).
GoalLesson to_lesson(const mbncc_vision::LearnObjectGoal& goal, const std::string& name,
                     const cv::Mat& before, const cv::Mat& after);

class LessonDraft {
 public:
  /// The references must outlive the draft. `name` is the name of the object.
  LessonDraft(const mbncc_vision::LearnObjectGoal& goal, std::string name, const LessonTools& tools,
              const LessonImages& images, LessonFeedback& feedback);

  /// Learns from the current images.
  void learn();

  /// The result of the images and all edits in force, compared with the library.
  const LearnResult& learned() const { return learned_; }

  /// Whether the object was put down so near its old place that the map contains both places.
  bool overlaps_old_place() const;

  /// Whether the verdict allows storing, or the goal allows the verdict BAD.
  bool may_be_stored() const;

  /// Whether the further view would be refused, whatever its verdict.
  bool is_view_refused() const { return view_refused_; }

  /// As in InteractiveLesson; the new result is compared and shown again.
  LearnResult edit(const LessonEdit& edit);
  bool undo();

 private:
  Lesson lesson() const;
  StageObserver observer();
  void update();
  void try_further_view();

  const mbncc_vision::LearnObjectGoal& goal_;
  const std::string name_;
  const LessonTools& tools_;
  const LessonImages& images_;
  LessonFeedback& feedback_;
  std::optional<InteractiveLesson> interactive_;
  LearnResult learned_;
  bool view_refused_ = false;
};

}  // namespace mbncc::nodelets
