// SPDX-License-Identifier: BSD-3-Clause
// A client of the LearnObject action for rostests. It uses plain topics, so that it works with any
// clock and with several goals at a time.
#pragma once

#include <actionlib_msgs/GoalID.h>
#include <gtest/gtest.h>
#include <mbncc_vision/LearnObjectActionFeedback.h>
#include <mbncc_vision/LearnObjectActionGoal.h>
#include <mbncc_vision/LearnObjectActionResult.h>
#include <ros/ros.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "nodelets/spin_until.hpp"

namespace mbncc::nodelets {

/// Removes the nodelets' library folder, which has a unique name from the launch file.
inline void remove_library() {
  std::string path;
  if (ros::param::get("learning/library_path", path)) std::filesystem::remove_all(path);
}

class Teacher {
 public:
  using Goal = mbncc_vision::LearnObjectGoal;
  using Result = mbncc_vision::LearnObjectResult;
  using Feedback = mbncc_vision::LearnObjectFeedback;

  /// `cell`: namespace of the learning nodelet.
  explicit Teacher(const std::string& cell = "") : node_(cell) {
    goals_ = node_.advertise<mbncc_vision::LearnObjectActionGoal>("learn_object/goal", 10);
    cancels_ = node_.advertise<actionlib_msgs::GoalID>("learn_object/cancel", 10);
    results_ = node_.subscribe<mbncc_vision::LearnObjectActionResult>(
        "learn_object/result", 10, [this](const auto& result) {
          if (sent_.count(result->status.goal_id.id) > 0)
            ended_[result->status.goal_id.id] = *result;
        });
    feedbacks_ = node_.subscribe<mbncc_vision::LearnObjectActionFeedback>(
        "learn_object/feedback", 100, [this](const auto& feedback) {
          if (sent_.count(feedback->status.goal_id.id) == 0) return;
          heard_[feedback->status.goal_id.id] = feedback->feedback;
          passed_[feedback->status.goal_id.id].insert(feedback->feedback.stage);
        });
  }

  bool connect() {
    return spin_until([this] {
      return goals_.getNumSubscribers() > 0 && cancels_.getNumSubscribers() > 0 &&
             results_.getNumPublishers() > 0 && feedbacks_.getNumPublishers() > 0;
    });
  }

  /// Sends a goal; returns its id.
  std::string send(const Goal& goal) {
    mbncc_vision::LearnObjectActionGoal message;
    message.goal = goal;
    message.goal_id.id = fresh_id();
    sent_.insert(message.goal_id.id);
    goals_.publish(message);
    return message.goal_id.id;
  }

  void cancel(const std::string& id) {
    actionlib_msgs::GoalID message;
    message.id = id;
    cancels_.publish(message);
  }

  bool ended(const std::string& id) const { return ended_.count(id) > 0; }
  bool heard(const std::string& id, std::uint8_t stage) const {
    const auto feedback = heard_.find(id);
    return feedback != heard_.end() && feedback->second.stage == stage;
  }

  /// The last message of a running lesson.
  const Feedback& last_feedback(const std::string& id) { return heard_[id]; }

  /// True if the lesson is in this stage or was in it before.
  bool has_been_in(const std::string& id, std::uint8_t stage) const {
    const auto stages = passed_.find(id);
    return stages != passed_.end() && stages->second.count(stage) > 0;
  }

  /// Waits for the result of a goal. `status` as in actionlib_msgs/GoalStatus.
  mbncc_vision::LearnObjectActionResult await(const std::string& id) {
    EXPECT_TRUE(spin_until([&] { return ended(id); }, std::chrono::seconds(90))) << id;
    return ended_[id];
  }

  /// Drops the messages of a goal, because the results of many lessons contain images. Late
  /// messages are ignored.
  void forget(const std::string& id) {
    sent_.erase(id);
    ended_.erase(id);
    heard_.erase(id);
    passed_.erase(id);
  }

  Result teach(const Goal& goal) { return await(send(goal)).result; }

 private:
  // The server remembers ids for some seconds and ignores a goal with a known id.
  static std::string fresh_id() {
    static int sent = 0;
    return "goal_" + std::to_string(++sent);
  }

  ros::NodeHandle node_;
  ros::Publisher goals_, cancels_;
  ros::Subscriber results_, feedbacks_;
  std::set<std::string> sent_;
  std::map<std::string, mbncc_vision::LearnObjectActionResult> ended_;
  std::map<std::string, Feedback> heard_;
  std::map<std::string, std::set<std::uint8_t>> passed_;
};

}  // namespace mbncc::nodelets
