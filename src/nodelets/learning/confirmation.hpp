// SPDX-License-Identifier: BSD-3-Clause
// Connects the confirm_learning service with the lesson that waits for it.
#pragma once

#include <mbncc_vision/ConfirmLearning.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace mbncc::nodelets {

class Confirmation {
 public:
  using Request = mbncc_vision::ConfirmLearning::Request;
  using Response = mbncc_vision::ConfirmLearning::Response;

  /// Service side: passes the command to the waiting lesson and waits for its answer. Refuses with
  /// a message if no lesson waits, or if the command is meant for another one.
  Response ask(const Request& request);

  /// Lesson side: accepts commands for the lesson with the goal `goal_id` from now on; call this
  /// before the operator is asked.
  void open(const std::string& goal_id);

  /// Lesson side: waits for a command; none once `interrupted` returns true, or after `patience`.
  std::optional<Request> next(const std::function<bool()>& interrupted,
                              std::chrono::milliseconds patience);

  /// Lesson side: answers the command returned by next().
  void answer(const Response& response);

  /// Lesson side: accepts no more commands; an unanswered one is refused.
  void close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  std::string goal_id_;
  std::optional<Request> request_;
  std::optional<Response> response_;
};

}  // namespace mbncc::nodelets
