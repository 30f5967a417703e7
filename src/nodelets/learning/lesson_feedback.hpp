// SPDX-License-Identifier: BSD-3-Clause
// What a running lesson tells its client, and its early end.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>
#include <sensor_msgs/RegionOfInterest.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/error.hpp"
#include "nodelets/learning/lesson_server.hpp"

namespace mbncc::nodelets {

/// Progress of a whole lesson at the end of taking images, of learning, of the operator's check.
constexpr double kTaken = 0.3, kLearned = 0.9, kChecked = 0.95;

/// Ends a lesson from any depth: thrown by end_lesson() alone, caught in LessonSession::run().
struct LessonEnded {
  mbncc_vision::LearnObjectResult result;
};

[[noreturn]] void end_lesson(const mbncc_vision::LearnObjectResult& result);
/// Texts given here replace the error's own.
[[noreturn]] void end_lesson(LearnError error, const std::string& message = "",
                             const std::string& hint = "");

class LessonFeedback {
 public:
  /// `client` outlives it.
  explicit LessonFeedback(LessonClient& client);

  /// `stage` of LearnObjectFeedback, `progress` [0..1] of the whole lesson.
  void tell(std::uint8_t stage, double progress, const std::string& message);

  /// The same, of what the operator has to do.
  void ask(std::uint8_t stage, double progress, const std::string& request);

  /// "": the operator was not asked for anything.
  const std::string& last_request() const { return last_request_; }

  /// Where the object is [px], told from now on; none: the goal's region.
  void set_place(const std::optional<cv::Rect>& place);

  std::optional<LearnError> interruption() const { return client_.interruption(); }

  /// Ends the lesson if it was cancelled or its time is over.
  void leave_if_interrupted() const;

 private:
  void send(std::uint8_t stage, double progress, const std::string& message, bool operator_action);

  LessonClient& client_;
  sensor_msgs::RegionOfInterest place_;
  std::string last_request_;
};

}  // namespace mbncc::nodelets
