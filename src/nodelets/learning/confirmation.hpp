// SPDX-License-Identifier: BSD-3-Clause
// Where the confirm_learning service and the lesson that waits for it meet.
#pragma once

#include <mbncc_vision/ConfirmLearning.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace mbncc::nodelets {

class Confirmation {
 public:
  using Request = mbncc_vision::ConfirmLearning::Request;
  using Response = mbncc_vision::ConfirmLearning::Response;

  /// Service side: hands the command to the waiting lesson and waits for its answer. Refuses with a
  /// sentence when no lesson waits.
  Response ask(const Request& request);

  /// Lesson side: commands are taken from now on; before the operator is told to give one.
  void open();

  /// Lesson side: waits for a command; none once `interrupted` says so, or after `patience`.
  std::optional<Request> next(const std::function<bool()>& interrupted,
                              std::chrono::milliseconds patience);

  /// Lesson side: answers the command that next() gave.
  void answer(const Response& response);

  /// Lesson side: no more commands; one that has not been answered is refused.
  void close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  std::optional<Request> request_;
  std::optional<Response> response_;
};

}  // namespace mbncc::nodelets
