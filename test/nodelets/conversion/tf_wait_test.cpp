// SPDX-License-Identifier: BSD-3-Clause
// Waiting for a robot's tf. A wait that is not justified would last an hour, so that the test would
// exceed its time limit.
#include "nodelets/conversion/tf_wait.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace mbncc::nodelets {
namespace {

constexpr double kHour = 3600;  // [s]
const ros::Time kStamp(10000);  // of the image

geometry_msgs::TransformStamped base_to_camera(const ros::Time& stamp) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = "base";
  transform.child_frame_id = "camera";
  transform.transform.rotation.w = 1;
  return transform;
}

void wait(const tf2_ros::Buffer& tf, double patience = kHour) {
  wait_for_transform(tf, "base", "camera", kStamp, patience);
}

TEST(TfWait, EndsWhenTheTransformArrives) {
  tf2_ros::Buffer tf;
  tf.setTransform(base_to_camera(kStamp - ros::Duration(0.02)), "robot");
  std::thread robot(
      [&tf] { tf.setTransform(base_to_camera(kStamp + ros::Duration(0.02)), "robot"); });
  wait(tf);
  robot.join();
  EXPECT_TRUE(tf.canTransform("base", "camera", kStamp));
}

TEST(TfWait, DoesNotWaitForAnAvailableTransform) {
  tf2_ros::Buffer tf;
  tf.setTransform(base_to_camera(kStamp), "robot");
  wait(tf);
}

TEST(TfWait, DoesNotWaitForAMissingFrame) {
  wait(tf2_ros::Buffer());
}

TEST(TfWait, DoesNotWaitForARobotThatStoppedPublishing) {
  tf2_ros::Buffer tf;
  tf.setTransform(base_to_camera(kStamp - ros::Duration(kHour + 1)), "robot");
  wait(tf);
}

TEST(TfWait, DoesNotWaitForAFixedTransform) {
  tf2_ros::Buffer tf;
  tf.setTransform(base_to_camera(ros::Time(1)), "robot", true);
  wait(tf);
}

TEST(TfWait, EndsAfterTheTimeout) {
  tf2_ros::Buffer tf;
  tf.setTransform(base_to_camera(kStamp - ros::Duration(0.001)), "robot");
  wait(tf, 0.01);
  wait(tf, 0);
  EXPECT_FALSE(tf.canTransform("base", "camera", kStamp));
}

std::string fault_at(const tf2_ros::Buffer& tf, const ros::Time& stamp) {
  try {
    tf.lookupTransform("base", "camera", stamp);
    return "";
  } catch (const tf2::TransformException& error) {
    return tf_fault(error);
  }
}

TEST(TfFault, NamesTheRemedyForFramesThatAreNotConnected) {
  const std::string remedy = "; publish the transforms";
  tf2_ros::Buffer tf;
  EXPECT_NE(fault_at(tf, kStamp).find("does not exist" + remedy), std::string::npos)
      << fault_at(tf, kStamp);
  geometry_msgs::TransformStamped other = base_to_camera(kStamp);
  tf.setTransform(other, "robot");
  other.header.frame_id = "world";
  other.child_frame_id = "table";
  tf.setTransform(other, "robot");
  try {
    tf.lookupTransform("base", "table", kStamp);
    FAIL();
  } catch (const tf2::TransformException& error) {
    EXPECT_NE(tf_fault(error).find(remedy), std::string::npos) << tf_fault(error);
  }
  EXPECT_EQ(fault_at(tf, kStamp - ros::Duration(1)).find(remedy), std::string::npos);
}

TEST(TfFault, NamesTheRemedyOnlyWhereWaitingHelps) {
  tf2_ros::Buffer tf;
  EXPECT_EQ(fault_at(tf, kStamp).find("tf_wait"), std::string::npos) << "nobody knows the frames";
  tf.setTransform(base_to_camera(kStamp - ros::Duration(0.02)), "robot");
  tf.setTransform(base_to_camera(kStamp), "robot");
  EXPECT_NE(fault_at(tf, kStamp + ros::Duration(1)).find("tf_wait"), std::string::npos);
  EXPECT_EQ(fault_at(tf, kStamp - ros::Duration(1)).find("tf_wait"), std::string::npos);
}

}  // namespace
}  // namespace mbncc::nodelets
