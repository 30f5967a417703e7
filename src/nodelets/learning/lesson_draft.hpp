// SPDX-License-Identifier: BSD-3-Clause
// What a lesson has learned so far: compared with the library, shown, and corrected by the
// operator.
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

/// The lesson of a goal that passed check_goal(), with these images (CV_8UC3; `after` is empty if
/// the mode needs none). On failure `fault` contains the result.
struct GoalLesson {
  Lesson lesson;
  std::optional<mbncc_vision::LearnObjectResult> fault;
};
GoalLesson to_lesson(const mbncc_vision::LearnObjectGoal& goal, const std::string& name,
                     const cv::Mat& before, const cv::Mat& after);

class LessonDraft {
 public:
  /// The references outlive it. `name` of the object.
  LessonDraft(const mbncc_vision::LearnObjectGoal& goal, std::string name, const LessonTools& tools,
              const LessonImages& images, LessonFeedback& feedback);

  /// From the images as they are now.
  void learn();

  /// Of the images and all edits in force, compared with the library.
  const LearnResult& learned() const { return learned_; }

  /// The object is still where it was: the map contains its old place and the new one.
  bool lies_there_yet() const;

  /// By its verdict, or because the goal allows BAD.
  bool may_be_stored() const;

  /// As InteractiveLesson does.
  LearnResult edit(const LessonEdit& edit);
  bool undo();

 private:
  Lesson lesson() const;
  StageObserver observer();
  void update();
  void note_refused_further_view();

  const mbncc_vision::LearnObjectGoal& goal_;
  const std::string name_;
  const LessonTools& tools_;
  const LessonImages& images_;
  LessonFeedback& feedback_;
  std::optional<InteractiveLesson> interactive_;
  LearnResult learned_;
};

}  // namespace mbncc::nodelets
