// SPDX-License-Identifier: BSD-3-Clause
// How the steps of a lesson report progress, are cancelled and give up. Private to the layer:
// learn_object() turns everything here into values.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc {

/// Ends a lesson that cannot go on; caught in learn_object() and nowhere else.
class LessonEnded : public std::runtime_error {
 public:
  /// `message` replaces the error's own sentence where it knows more.
  explicit LessonEnded(LearnError error, const std::string& message = "")
      : std::runtime_error(message.empty() ? message_of(error) : message), error_(error) {}

  LearnError error() const { return error_; }

 private:
  LearnError error_;
};

/// Passes steps on to the observer, keeps the progress from falling and the stages in order.
class LessonProgress {
 public:
  explicit LessonProgress(const StageObserver& observer) : observer_(observer) {}

  /// Makes the picture of a step; called only when somebody looks.
  using Picture = std::function<cv::Mat()>;

  /// Throws LessonEnded(kCancelled) when the observer asks to stop. `progress` is of the whole
  /// lesson, [0..1].
  void report(Stage stage, double progress, const std::string& message,
              const Picture& picture = {});

 private:
  const StageObserver& observer_;
  double highest_ = 0;
};

}  // namespace mbncc
