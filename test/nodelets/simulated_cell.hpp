// SPDX-License-Identifier: BSD-3-Clause
// A client of the simulated cell: its truth, its detections, and commands to its arm.
#pragma once

#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <string>

#include "nodelets/call_service.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

class SimulatedCell : public testing::Test {
 protected:
  SimulatedCell() {
    truths_ = node_.subscribe<DetectedObjectArray>(
        "camera/truth", 10, [this](const DetectedObjectArray::ConstPtr& truth) { truth_ = truth; });
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 10,
        [this](const DetectedObjectArray::ConstPtr& found) { found_ = found; });
  }

  /// Calls a service of the arm until the arm accepts, and waits until it moves.
  void order(const std::string& service) {
    ASSERT_TRUE(ros::service::waitForService(service, 30000));
    ASSERT_TRUE(spin_until([&] {
      std_srvs::Trigger trigger;
      return call_service(service, trigger) && trigger.response.success;
    })) << service;
    ASSERT_TRUE(spin_until([this] { return truth_ && truth_->message != "rest"; }));
  }

  /// Teaches the object that lies in the cell; the arm takes it away after `before_removal`.
  void teach(
      const std::string& name, const std::function<void()>& before_removal = [] {}) {
    Teacher teacher;
    ASSERT_TRUE(teacher.connect());
    ASSERT_TRUE(spin_until([this] { return rests(true); }));
    Teacher::Goal goal;
    goal.name = name;
    const std::string id = teacher.send(goal);
    ASSERT_TRUE(spin_until([&] { return teacher.heard(id, Teacher::Feedback::WAIT_REMOVAL); }));
    ASSERT_NO_FATAL_FAILURE(before_removal());
    order("camera/take_away");
    const auto lesson = teacher.await(id).result;
    ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
  }

  /// Whether the arm has left, and the object is present or not as given.
  bool rests(bool present) const {
    return truth_ && truth_->message == "rest" && truth_->objects.empty() != present;
  }

  /// The confirmed instance of `name` in an image taken after `stamp`; any name if `name` is empty.
  const DetectedObject* confirmed_since(const ros::Time& stamp,
                                        const std::string& name = "") const {
    if (!found_ || found_->header.stamp <= stamp) return nullptr;
    for (const auto& object : found_->objects)
      if ((name.empty() || object.name == name) && object.state == DetectedObject::CONFIRMED)
        return &object;
    return nullptr;
  }

  ros::NodeHandle node_;
  ros::Subscriber truths_, detections_;
  DetectedObjectArray::ConstPtr truth_, found_;
};

}  // namespace mbncc::nodelets
