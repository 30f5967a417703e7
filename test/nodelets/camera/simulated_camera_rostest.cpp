// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/Trigger.h>

#include <map>
#include <string>

#include "nodelets/call_service.hpp"
#include "nodelets/spin_until.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

class SimulatedCamera : public testing::Test {
 protected:
  SimulatedCamera() {
    images_ = node_.subscribe<sensor_msgs::Image>(
        "image_raw", 10, [this](const sensor_msgs::ImageConstPtr& image) { image_ = image; });
    infos_ = node_.subscribe<sensor_msgs::CameraInfo>(
        "camera_info", 10, [this](const sensor_msgs::CameraInfoConstPtr& info) { info_ = info; });
    truths_ = node_.subscribe<DetectedObjectArray>(
        "camera/truth", 10, [this](const DetectedObjectArray::ConstPtr& truth) {
          truth_ = truth;
          stamps_[truth->header.stamp.toNSec()] = truth;
        });
  }

  bool call(const std::string& service) {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::waitForService(service, 30000));
    EXPECT_TRUE(call_service(service, trigger));
    EXPECT_FALSE(trigger.response.message.empty());
    return trigger.response.success;
  }

  bool at_rest() const { return truth_ && truth_->message == "rest"; }

  ros::NodeHandle node_;
  ros::Subscriber images_, infos_, truths_;
  sensor_msgs::ImageConstPtr image_;
  sensor_msgs::CameraInfoConstPtr info_;
  DetectedObjectArray::ConstPtr truth_;
  std::map<std::uint64_t, DetectedObjectArray::ConstPtr> stamps_;
};

TEST_F(SimulatedCamera, PublishesImagesCalibrationAndTruthOfOneStamp) {
  ASSERT_TRUE(spin_until([this] {
    return image_ && info_ && info_->header.stamp == image_->header.stamp &&
           stamps_.count(image_->header.stamp.toNSec()) == 1;
  }));
  EXPECT_EQ(image_->encoding, "bgr8");
  EXPECT_EQ(image_->width, 320u);
  EXPECT_EQ(image_->height, 240u);
  EXPECT_EQ(image_->header.frame_id, "camera_optical_frame");
  EXPECT_EQ(info_->header.frame_id, "camera_optical_frame");
  EXPECT_EQ(info_->width, 320u);
  EXPECT_GT(info_->K[0], 0);
}

TEST_F(SimulatedCamera, PlaysTheStoryOnRequest) {
  ASSERT_TRUE(spin_until([this] { return at_rest() && truth_->objects.size() == 1; }));
  const DetectedObject first = truth_->objects[0];
  EXPECT_EQ(first.name, "object");
  EXPECT_EQ(first.state, DetectedObject::CONFIRMED);
  EXPECT_TRUE(first.pose_valid);
  EXPECT_NEAR(first.pose.pose.position.z, 0.6, 1e-9);

  ASSERT_TRUE(call("camera/take_away"));
  EXPECT_FALSE(call("camera/put_next")) << "the arm is under way";
  ASSERT_TRUE(spin_until([this] { return truth_->message == "carry"; }));
  ASSERT_TRUE(spin_until([this] { return at_rest() && truth_->objects.empty(); }));
  EXPECT_FALSE(call("camera/take_away")) << "nothing lies there";

  ASSERT_TRUE(call("camera/put_next"));
  ASSERT_TRUE(spin_until([this] { return at_rest() && truth_->objects.size() == 1; }));
  const DetectedObject second = truth_->objects[0];
  EXPECT_GT(std::abs(second.image_pose.x - first.image_pose.x) +
                std::abs(second.image_pose.y - first.image_pose.y),
            1);
  EXPECT_NE(second.image_pose.theta, first.image_pose.theta);
}

TEST_F(SimulatedCamera, PublishesDiagnosticsLikeACamera) {
  std::map<std::string, std::string> values;
  const auto reports = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 20, [&](const diagnostic_msgs::DiagnosticArray::ConstPtr& report) {
        const auto& status = report->status.at(0);
        EXPECT_EQ(status.name, "camera: pictures");
        EXPECT_EQ(status.message, "open");
        for (const auto& value : status.values) values[value.key] = value.value;
      });
  ASSERT_TRUE(spin_until([&] { return values["published"] > "0" && values["listeners"] == "1"; }));
  EXPECT_EQ(values["calibrated"], "yes");
  EXPECT_EQ(values["failures of the source"], "0");
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulated_camera_rostest");
  // Between tests, no other handle exists, and the node would shut down.
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
