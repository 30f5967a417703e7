// SPDX-License-Identifier: BSD-3-Clause
// Two cells with one library: an object taught in one is found in both, and the cells do not affect
// each other otherwise.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/LearnedObjectArray.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <unistd.h>

#include <string>

#include "nodelets/call_service.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

/// One of the two cells as its consumers see it.
class CellClient {
 public:
  explicit CellClient(const std::string& name)
      : name_(name),
        subscriber_(ros::NodeHandle().subscribe<DetectedObjectArray>(
            name + "/detected_objects", 10,
            [this](const DetectedObjectArray::ConstPtr& found) { found_ = found; })) {}

  bool sees(const std::string& frame) const {
    if (!found_ || found_->header.frame_id != name_ + "_camera_optical_frame") return false;
    for (const auto& object : found_->objects)
      if (object.state == DetectedObject::CONFIRMED && object.child_frame_id == frame) return true;
    return false;
  }

  bool searches_after(const ros::Time& stamp) const {
    return found_ && found_->header.stamp > stamp && found_->status != DetectedObjectArray::STALE;
  }

  bool enable(bool enabled) {
    std_srvs::SetBool call;
    call.request.data = enabled;
    return call_service(name_ + "/matching/enable", call) && call.response.success;
  }

 private:
  std::string name_;
  DetectedObjectArray::ConstPtr found_;
  ros::Subscriber subscriber_;
};

TEST(Cells, ShareOnlyTheLibrary) {
  ros::NodeHandle node;
  CellClient left("left"), right("right");
  mbncc_vision::LearnedObjectArray::ConstPtr library;
  const auto library_subscriber = node.subscribe<mbncc_vision::LearnedObjectArray>(
      "left/object_library", 1, [&](const auto& heard) { library = heard; });
  Teacher teacher("left");
  ASSERT_TRUE(teacher.connect());
  const auto image =
      ros::topic::waitForMessage<sensor_msgs::Image>("left/image_raw", ros::Duration(60));
  ASSERT_TRUE(image);
  Teacher::Goal goal;
  goal.name = "part";
  goal.mode = Teacher::Goal::ROI;
  goal.before = *image;
  goal.roi.x_offset = 110;
  goal.roi.y_offset = 70;
  goal.roi.width = goal.roi.height = 100;
  goal.allow_bad = true;
  const auto lesson = teacher.teach(goal);
  ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
  EXPECT_TRUE(spin_until([&] { return library && library->objects.size() == 1; }));
  char host[256] = {};
  ASSERT_EQ(::gethostname(host, sizeof host - 1), 0);
  EXPECT_EQ(lesson.object.taught_by, std::string(host) + "/left");
  EXPECT_TRUE(spin_until([&] { return left.sees("left_object_part_0"); }));
  EXPECT_TRUE(spin_until([&] { return right.sees("right_object_part_0"); }))
      << "taught in the other cell";

  ASSERT_TRUE(left.enable(false));
  const ros::Time then = ros::Time::now();
  EXPECT_TRUE(spin_until([&] { return right.searches_after(then); }));
  EXPECT_FALSE(left.searches_after(then + ros::Duration(0.5)));
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "cells_rostest");
  const ros::NodeHandle keeps_the_node_running;
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
