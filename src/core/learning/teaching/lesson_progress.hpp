// SPDX-License-Identifier: BSD-3-Clause
// Progress, cancellation and failure of a lesson's steps. Internal: run_lesson() and run_edit()
// convert all of it to a LearnResult.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "mbncc/learning/lesson.hpp"

namespace mbncc::teaching {

/// Ends a lesson or a correction that cannot continue. The caller of the steps converts it to a
/// LearnResult, so it is never thrown out of the core.
class LessonEnded : public std::runtime_error {
 public:
  /// `message` and `hint` replace the error's default texts.
  explicit LessonEnded(LearnError error, const std::string& message = "",
                       const std::string& hint = "")
      : std::runtime_error(message.empty() ? message_of(error) : message),
        error_(error),
        hint_(hint.empty() ? hint_of(error) : hint) {}

  LearnError error() const { return error_; }
  const std::string& hint() const { return hint_; }

 private:
  LearnError error_;
  std::string hint_;
};

/// Throws LessonEnded unless the condition holds.
inline void require(bool condition, LearnError error, const std::string& message,
                    const std::string& hint = "") {
  if (!condition) throw LessonEnded(error, message, hint);
}

/// Reports steps to the observer, with monotonic progress and ordered stages.
class LessonProgress {
 public:
  explicit LessonProgress(const StageObserver& observer) : observer_(observer) {}

  /// Makes the image of a step; called only if there is an observer.
  using Image = std::function<cv::Mat()>;

  /// Throws LessonEnded(kCancelled) when the observer asks to stop. `progress` is of the whole
  /// lesson, [0..1].
  void report(Stage stage, double progress, const std::string& message, const Image& image = {});

 private:
  const StageObserver& observer_;
  double highest_ = 0;
};

}  // namespace mbncc::teaching
