// SPDX-License-Identifier: BSD-3-Clause
// The LearnObject action: one lesson at a time, on its own thread. A second goal is rejected with
// BUSY and does not affect the running one.
#pragma once

#include <actionlib/server/action_server.h>
#include <mbncc_vision/LearnObjectAction.h>
#include <ros/node_handle.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {

/// The client of a running lesson: goal, cancellation and feedback.
class LessonClient {
 public:
  using Handle = actionlib::ActionServer<mbncc_vision::LearnObjectAction>::GoalHandle;

  /// `timeout` [s] limits the whole lesson; if it is 0, `default_timeout` [s] limits the part
  /// before the operator's review.
  LessonClient(Handle handle, double timeout, double default_timeout);

  const mbncc_vision::LearnObjectGoal& goal() const { return *goal_; }
  std::string goal_id() const { return handle_.getGoalID().id; }

  /// Why the lesson must end now: cancelled or out of time. None: it may continue.
  std::optional<LearnError> interruption() const;

  /// Call this when the review begins. It has no time limit unless the goal set a timeout.
  void wait_for_operator();

  /// [s] until the deadline, by the steady clock; none if there is no deadline.
  std::optional<double> remaining() const;

  /// Publishes feedback; fills in `remaining`, 0 without a deadline, and keeps `progress`
  /// monotonic.
  void tell(mbncc_vision::LearnObjectFeedback feedback);

 private:
  friend class LessonServer;
  Handle handle_;
  boost::shared_ptr<const mbncc_vision::LearnObjectGoal> goal_;
  bool own_timeout_;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
  std::atomic<bool> cancelled_{false};
  std::atomic<bool> stopped_{false};
  float progress_ = 0;
};

/// Action server that drops the images of finished goals: actionlib stores goals for some seconds
/// after their end for late clients, and hundreds may be sent.
class LessonActionServer : public actionlib::ActionServer<mbncc_vision::LearnObjectAction> {
 public:
  using actionlib::ActionServer<mbncc_vision::LearnObjectAction>::ActionServer;

  /// Drops the contents of goals that no handle refers to; their id and status stay.
  void forget_images();

 private:
  const boost::shared_ptr<const ActionGoal> without_images_ = boost::make_shared<ActionGoal>();
};

class LessonServer {
 public:
  /// Result to reject a goal with, or none to accept it. Called on the callback thread.
  using Admit = std::function<std::optional<mbncc_vision::LearnObjectResult>(
      const mbncc_vision::LearnObjectGoal&)>;
  /// Runs a lesson; called on the worker thread. Must return soon after an interruption().
  using Teach = std::function<mbncc_vision::LearnObjectResult(LessonClient&)>;

  LessonServer(ros::NodeHandle node, const std::string& name, double default_timeout, Admit admit,
               Teach teach);
  /// Calls end().
  ~LessonServer();

  bool busy() const;

  /// Ends a running lesson with ABORTED and accepts no more goals.
  void end();

 private:
  void on_goal(LessonClient::Handle handle);
  void on_cancel(LessonClient::Handle handle);
  std::optional<mbncc_vision::LearnObjectResult> refusal(const mbncc_vision::LearnObjectGoal& goal);
  bool reserve(const std::shared_ptr<LessonClient>& client);
  void work();
  mbncc_vision::LearnObjectResult teach_safely(LessonClient& client);
  void finish(LessonClient& client, const mbncc_vision::LearnObjectResult& result);

  const double default_timeout_;
  const Admit admit_;
  const Teach teach_;
  mutable std::mutex mutex_;  // never held while calling the action server, which has its own mutex
  std::condition_variable changed_;
  std::shared_ptr<LessonClient> running_;
  bool accepted_ = false;
  bool stopping_ = false;
  LessonActionServer server_;
  std::thread worker_;
};

}  // namespace mbncc::nodelets
