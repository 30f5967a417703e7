// SPDX-License-Identifier: BSD-3-Clause
// Poses in metres: a strongly distorted simulated camera, the platform from tf, a grasp marked in a
// lesson.
#include <geometry_msgs/PoseArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_listener.h>

#include <cmath>
#include <map>
#include <string>

#include "mbncc/geometry.hpp"
#include "nodelets/call_service.hpp"
#include "nodelets/simulated_cell.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

constexpr int kPlaces = 3;
// The gripper's pose at the demonstration, as in the launch file.
const Pose2D kGripper{0.02, 0.03, kPi / 4};  // [m], [rad] in the camera's x and y

Pose2D planar(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y, 2 * std::atan2(pose.orientation.z, pose.orientation.w)};
}

class Metric : public SimulatedCell {
 protected:
  Metric() {
    poses_subscriber_ = node_.subscribe<geometry_msgs::PoseArray>(
        "matching/poses", 10, [this](const geometry_msgs::PoseArray::ConstPtr& poses) {
          poses_[poses->header.stamp] = *poses;
        });
  }

  ros::Subscriber poses_subscriber_;
  std::map<ros::Time, geometry_msgs::PoseArray> poses_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_{tf_};
};

TEST_F(Metric, ObjectAndGraspAreWhereTheyAreInTheWorld) {
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  ASSERT_TRUE(spin_until([this] { return rests(true); }));
  const Pose2D shown = planar(truth_->objects[0].pose.pose);
  Teacher::Goal goal;
  goal.name = "part";
  const std::string id = teacher.send(goal);
  ASSERT_TRUE(spin_until([&] { return teacher.heard(id, Teacher::Feedback::WAIT_REMOVAL); }));
  std_srvs::Trigger mark;
  ASSERT_TRUE(call_service("mark_grasp", mark));
  ASSERT_TRUE(mark.response.success) << mark.response.message;
  order("camera/take_away");
  const auto lesson = teacher.await(id).result;
  ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
  EXPECT_NEAR(lesson.object.metres_per_pixel, 0.7 / 340, 1e-6);
  EXPECT_EQ(lesson.object.taught_by, "line 3, left") << "as the nodelet's cell_name says";
  ASSERT_TRUE(lesson.object.has_grasp) << lesson.message;
  const Pose2D gripper_in_drawing = compose(inverse(shown), kGripper);

  for (int place = 0; place < kPlaces; ++place) {
    order("camera/put_next");
    ASSERT_TRUE(spin_until([this] { return rests(true); }));
    const ros::Time since = truth_->header.stamp;
    ASSERT_TRUE(spin_until([&] { return confirmed_since(since) != nullptr; }));
    const DetectedObject object = *confirmed_since(since);
    const ros::Time stamp = found_->header.stamp;
    ASSERT_TRUE(object.pose_valid);
    EXPECT_NEAR(object.pose.pose.position.z, 0.7, 1e-6);
    EXPECT_GT(object.pose.covariance[0], 0);
    ASSERT_TRUE(spin_until([&] { return poses_.count(stamp) == 1; }));
    ASSERT_EQ(poses_[stamp].poses.size(), 1u);
    EXPECT_EQ(poses_[stamp].poses[0], object.pose.pose);
    ASSERT_TRUE(object.has_grasp);
    EXPECT_NEAR(object.grasp.position.z, 0.6, 1e-6);
    const std::string frame = object.child_frame_id + "_grasp";
    ASSERT_TRUE(spin_until([&] { return tf_.canTransform("camera_optical_frame", frame, stamp); }));
    const auto t = tf_.lookupTransform("camera_optical_frame", frame, stamp).transform;
    const Pose2D expected = compose(planar(truth_->objects[0].pose.pose), gripper_in_drawing);
    EXPECT_LE(std::hypot(t.translation.x - expected.x, t.translation.y - expected.y), 0.002);
    EXPECT_NEAR(t.translation.z, 0.6, 1e-6);
    const double theta = 2 * std::atan2(t.rotation.z, t.rotation.w);
    EXPECT_LE(to_degrees(angle_distance(theta, expected.theta)), 1);
  }
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "metric_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
