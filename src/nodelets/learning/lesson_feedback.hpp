// SPDX-License-Identifier: BSD-3-Clause
// Sends the feedback of a running lesson to its client, and ends a lesson early.
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

/// Progress [0..1] of a lesson when the images are taken, the object is learned, and the operator
/// has checked it.
constexpr double kTaken = 0.3, kLearned = 0.9, kChecked = 0.95;

/// Exception that ends a lesson from any depth; thrown only by end_lesson(), caught in
/// LessonSession::run().
struct LessonEnded {
  mbncc_vision::LearnObjectResult result;
};

[[noreturn]] void end_lesson(const mbncc_vision::LearnObjectResult& result);
/// Texts that are not empty replace those of the error.
[[noreturn]] void end_lesson(LearnError error, const std::string& message = "",
                             const std::string& hint = "");

class LessonFeedback {
 public:
  /// `client` must outlive this object.
  explicit LessonFeedback(LessonClient& client);

  /// Sends a message. `stage` is a constant of LearnObjectFeedback, `progress` [0..1] that of the
  /// whole lesson.
  void tell(std::uint8_t stage, double progress, const std::string& message);

  /// Sends a message about what the operator has to do.
  void ask(std::uint8_t stage, double progress, const std::string& request);

  /// The last message of ask(); "" if there was none.
  const std::string& last_request() const { return last_request_; }

  /// Sets the object's box [px] in the feedback from now on; none: the goal's region.
  void set_place(const std::optional<cv::Rect>& place);

  std::optional<LearnError> interruption() const { return client_.interruption(); }

  /// Ends the lesson if it was cancelled or has timed out.
  void leave_if_interrupted() const;

 private:
  void send(std::uint8_t stage, double progress, const std::string& message, bool operator_action);

  LessonClient& client_;
  sensor_msgs::RegionOfInterest place_;
  std::string last_request_;
};

}  // namespace mbncc::nodelets
