// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/grasp_mark.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mbncc::nodelets {
namespace {

// The gripper is 0.1 m in front of the camera's object plane, rotated by 90 degrees about z.
geometry_msgs::TransformStamped gripper_in_camera() {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time(10);
  transform.header.frame_id = "camera";
  transform.child_frame_id = "gripper";
  transform.transform.translation.x = 0.2;
  transform.transform.translation.z = 0.5;
  transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);
  return transform;
}

Eigen::Isometry3d object_in_camera() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(0.2, 0.1, 0.6);
  pose.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // also rotated by 90 degrees about z
  return pose;
}

TEST(GraspMark, IsTheGrippersPoseInTheObjectsFrame) {
  tf2_ros::Buffer tf;
  tf.setTransform(gripper_in_camera(), "test", true);
  GraspMark mark(tf, "gripper");
  EXPECT_FALSE(mark.relative_to(object_in_camera()));
  ros::Time::init();
  ros::Time::setNow(ros::Time(10.1));
  mark.record("camera", ros::Time(10.1));
  EXPECT_TRUE(mark.is_marked_since(ros::Time(10)));
  EXPECT_FALSE(mark.is_marked_since(ros::Time(10.2)));
  const auto grasp = mark.relative_to(object_in_camera());
  ASSERT_TRUE(grasp);
  EXPECT_NEAR(grasp->position[0], -0.1, 1e-12);
  EXPECT_NEAR(grasp->position[1], 0, 1e-12);
  EXPECT_NEAR(grasp->position[2], -0.1, 1e-12);
  EXPECT_NEAR(std::abs(grasp->orientation[3]), 1, 1e-12);
  mark.clear();
  EXPECT_FALSE(mark.relative_to(object_in_camera()));
}

TEST(GraspMark, IsOfAnotherDemonstrationAfterTheClockJumpedBack) {
  tf2_ros::Buffer tf;
  tf.setTransform(gripper_in_camera(), "test", true);
  GraspMark mark(tf, "gripper");
  mark.record("camera", ros::Time(10.1));
  ros::Time::init();
  ros::Time::setNow(ros::Time(5));
  EXPECT_FALSE(mark.is_marked_since(ros::Time(4)));
}

TEST(GraspMark, RefusesWithAReason) {
  tf2_ros::Buffer tf;
  EXPECT_THROW(GraspMark(tf, "").record("camera", ros::Time(10)), std::runtime_error);
  EXPECT_THROW(GraspMark(tf, "gripper").record("", ros::Time(10)), std::runtime_error);
  EXPECT_THROW(GraspMark(tf, "gripper").record("camera", ros::Time(10)), std::runtime_error);
}

TEST(GraspMark, RefusesAnOldGripperPose) {
  tf2_ros::Buffer tf;
  tf.setTransform(gripper_in_camera(), "test", false);
  EXPECT_NO_THROW(GraspMark(tf, "gripper").record("camera", ros::Time(10.3)));
  EXPECT_THROW(GraspMark(tf, "gripper").record("camera", ros::Time(20)), std::runtime_error);
}

}  // namespace
}  // namespace mbncc::nodelets
