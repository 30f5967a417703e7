// SPDX-License-Identifier: BSD-3-Clause
// A client of one cell whose only images and calibration are those that the test provides.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <mbncc_vision/ConfirmLearning.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/ListObjects.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <string>
#include <vector>

#include "mbncc/sim/scene.hpp"
#include "nodelets/call_service.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;
using mbncc_vision::EditObject;

class Protocol : public testing::Test {
 protected:
  using Goal = Teacher::Goal;
  using Result = Teacher::Result;
  using ConfirmLearning = mbncc_vision::ConfirmLearning;

  Protocol() {
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 100, [this](const DetectedObjectArray::ConstPtr& array) {
          array_ = array;
          ++arrays_;
        });
    transforms_ = node_.subscribe<tf2_msgs::TFMessage>(
        "/tf", 100, [this](const tf2_msgs::TFMessage::ConstPtr&) { ++transforms_heard_; });
    reports_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 20, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& report) {
          for (const auto& status : report->status)
            for (const std::string nodelet : {"learning", "matching"})
              if (status.name.find(nodelet) != std::string::npos) health_[nodelet] = status;
        });
    images_ = node_.advertise<sensor_msgs::Image>("image_raw", 1);
    before_ = encode_image(scene_.render({part_}, 1));
    after_ = encode_image(scene_.render({}, 2));
  }

  void SetUp() override {
    ASSERT_TRUE(teacher_.connect());
    ASSERT_TRUE(ros::service::waitForService("find_objects", 30000));
  }

  static sim::SceneConfig scene_config() {
    sim::SceneConfig config;
    config.size = {320, 240};
    return config;
  }

  Goal given(const std::string& name) const {
    Goal goal;
    goal.name = name;
    goal.before = before_;
    goal.after = after_;
    return goal;
  }

  // Publishes images of the part, without calibration, as long as the returned timer exists.
  ros::WallTimer play() {
    return node_.createWallTimer(ros::WallDuration(0.1), [this](const auto&) {
      std_msgs::Header header;
      header.stamp = ros::Time::now();
      header.frame_id = "camera";
      images_.publish(encode_image(scene_.render({part_}, ++frame_), header));
    });
  }

  void expect_refused(const Goal& goal, int code) {
    const auto end = teacher_.await(teacher_.send(goal));
    EXPECT_EQ(end.status.status, actionlib_msgs::GoalStatus::REJECTED) << end.result.message;
    EXPECT_EQ(end.result.error_code, code) << end.result.message;
    EXPECT_FALSE(end.result.message.empty());
    EXPECT_FALSE(end.result.hint.empty());
  }

  bool status_is(std::uint8_t status) const { return array_ && array_->status == status; }

  /// Whether the diagnostics of a nodelet have this level.
  bool health_is(const std::string& nodelet, int level, const std::string& start = "") {
    const auto& status = health_[nodelet];
    return !status.name.empty() && status.level == level && status.message.rfind(start, 0) == 0;
  }

  template <class Service>
  typename Service::Response call(const std::string& name,
                                  const typename Service::Request& request) {
    Service service;
    service.request = request;
    EXPECT_TRUE(call_service(name, service)) << name;
    return service.response;
  }

  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const auto& object : call<mbncc_vision::ListObjects>("list_objects", {}).objects)
      names.push_back(object.name);
    return names;
  }

  EditObject::Response edit(const std::string& name, std::uint8_t command,
                            const std::string& new_name = "") {
    EditObject::Request request;
    request.name = name;
    request.command = command;
    request.new_name = new_name;
    return call<EditObject>("edit_object", request);
  }

  ConfirmLearning::Response confirm(std::uint8_t command) {
    ConfirmLearning::Request request;
    request.command = command;
    return call<ConfirmLearning>("confirm_learning", request);
  }

  const sim::Scene scene_{scene_config()};
  const sim::Placed part_{{11, 70, 1.6}, {160.2, 120.4, 0.3}};
  sensor_msgs::Image before_, after_;
  std::uint64_t frame_ = 10;
  ros::NodeHandle node_;
  Teacher teacher_;
  ros::Subscriber detections_, transforms_, reports_;
  std::map<std::string, diagnostic_msgs::DiagnosticStatus> health_;
  ros::Publisher images_;
  DetectedObjectArray::ConstPtr array_;
  int arrays_ = 0, transforms_heard_ = 0;
};

}  // namespace mbncc::nodelets
