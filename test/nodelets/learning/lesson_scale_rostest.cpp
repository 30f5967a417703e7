// SPDX-License-Identifier: BSD-3-Clause
// Metric data of a lesson from calibration and tf: scale and marked grasp. Images are given with
// the goals; the test publishes tf.
#include <gtest/gtest.h>
#include <mbncc_vision/ConfirmLearning.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <string>

#include "nodelets/call_service.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/drawn_images.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kDistance = 0.7;              // [m] of the platform
const cv::Vec3d kGripper{0.02, 0.03, 0.6};     // [m] in the camera's frame
const cv::Vec3d kCameraMotion{0.1, -0.05, 0};  // [m]

class LessonScale : public testing::Test {
 protected:
  using Goal = Teacher::Goal;
  using Result = Teacher::Result;

  LessonScale() {
    transforms_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10);
    infos_ = node_.advertise<sensor_msgs::CameraInfo>("camera_info", 1, true);
    infos_.publish(drawn_camera_info({}));
  }

  void SetUp() override {
    ASSERT_TRUE(teacher_.connect());
    ASSERT_TRUE(ros::service::waitForService("mark_grasp", 30000));
    ASSERT_TRUE(spin_until([this] { return transforms_.getNumSubscribers() > 0; }));
    place(ros::Time::now());
  }

  // Publishes platform and gripper on tf, with the camera displaced by `motion`, and marks the
  // grasp. The nodelet must then have received them, because its last gripper pose was too old to
  // be marked.
  void place(const ros::Time& stamp, const cv::Vec3d& motion = {}) {
    ASSERT_TRUE(spin_until([this] { return !mark(); }));
    tf2_msgs::TFMessage message;
    message.transforms = {transform("platform", stamp, cv::Vec3d(0, 0, kDistance) - motion),
                          transform("gripper", stamp, kGripper - motion)};
    // The platform's frame points towards the camera.
    std::swap(message.transforms[0].transform.rotation.x,
              message.transforms[0].transform.rotation.w);
    transforms_.publish(message);
    ASSERT_TRUE(spin_until([this] { return mark(); }));
    stamp_ = stamp;
  }

  static geometry_msgs::TransformStamped transform(const std::string& frame, const ros::Time& stamp,
                                                   const cv::Vec3d& place) {
    geometry_msgs::TransformStamped made;
    made.header.stamp = stamp;
    made.header.frame_id = "camera";
    made.child_frame_id = frame;
    made.transform.translation.x = place[0];
    made.transform.translation.y = place[1];
    made.transform.translation.z = place[2];
    made.transform.rotation.w = 1;
    return made;
  }

  static bool mark() {
    std_srvs::Trigger service;
    return call_service("mark_grasp", service) && service.response.success;
  }

  Goal goal(const std::string& name, const Pose2D& pose) const {
    const auto part = drawn_part(80, pose);
    Goal goal;
    goal.name = name;
    goal.mode = Goal::MASK;
    goal.before = encode_image(scene_.render({part}, 1));
    goal.before.header.stamp = stamp_;
    goal.before.header.frame_id = "camera";
    goal.mask = encode_image(scene_.true_map(part));
    goal.camera_info = drawn_camera_info(goal.before.header);
    return goal;
  }

  // Begins a lesson that waits for the operator.
  std::string begin(Goal goal) {
    goal.confirm = true;
    const std::string id = teacher_.send(goal);
    EXPECT_TRUE(spin_until(
        [&] { return teacher_.heard(id, Teacher::Feedback::WAIT_CONFIRM) || teacher_.ended(id); }));
    return id;
  }

  Result accept(const std::string& id) {
    mbncc_vision::ConfirmLearning service;
    service.request.command = mbncc_vision::ConfirmLearning::Request::ACCEPT;
    EXPECT_TRUE(call_service("confirm_learning", service));
    return teacher_.await(id).result;
  }

  // Checks the gripper's position in the frame of an object whose top face is `height` above the
  // platform.
  static void expect_grasp(const Result& lesson, const cv::Point2d& reference, double height) {
    ASSERT_EQ(lesson.error_code, Result::SUCCESS) << lesson.message;
    ASSERT_TRUE(lesson.object.has_grasp) << lesson.message;
    const double z = kDistance - height;
    const auto& grasp = lesson.object.grasp.position;
    EXPECT_NEAR(grasp.x, kGripper[0] - z * (reference.x - kCentreX) / kFocalLength, 1e-3);
    EXPECT_NEAR(grasp.y, kGripper[1] - z * (reference.y - kCentreY) / kFocalLength, 1e-3);
    EXPECT_NEAR(grasp.z, kGripper[2] - z, 1e-6);
  }

  const sim::Scene scene_{drawn_scene()};
  const Pose2D pose_{150.3, 130.6, 0};
  ros::NodeHandle node_;
  Teacher teacher_;
  ros::Publisher transforms_, infos_;
  ros::Time stamp_;
};

TEST_F(LessonScale, AFurtherViewsGraspIsMeasuredAtTheStoredHeight) {
  Goal tall = goal("tall", pose_);
  tall.object_height = 0.05;
  const Result first = teacher_.teach(tall);
  ASSERT_EQ(first.error_code, Result::SUCCESS) << first.message;
  EXPECT_NEAR(first.object.metres_per_pixel, (kDistance - 0.05) / kFocalLength, 1e-6);

  const Pose2D moved{260.2, 160.7, 0};
  Goal view = goal("tall", moved);
  view.add_view = true;
  const std::string id = begin(view);
  place(ros::Time::now());
  const Result second = accept(id);
  EXPECT_EQ(second.object.object_height, 0.05);
  const cv::Point2d learned(first.object.reference.x, first.object.reference.y);
  expect_grasp(second, learned + cv::Point2d(moved.x - pose_.x, moved.y - pose_.y), 0.05);
}

TEST_F(LessonScale, AGraspMayBeMarkedAfterTheCameraHasMoved) {
  const std::string id = begin(goal("moved", pose_));
  place(ros::Time::now(), kCameraMotion);
  const Result lesson = accept(id);
  expect_grasp(lesson, {lesson.object.reference.x, lesson.object.reference.y}, 0);
}

TEST_F(LessonScale, AnObjectLearnedWithoutScaleReportsIt) {
  Goal early = goal("early", pose_);
  early.before.header.stamp -= ros::Duration(100);
  const Result lesson = teacher_.teach(early);
  EXPECT_EQ(lesson.error_code, Result::SUCCESS) << lesson.message;
  EXPECT_TRUE(std::isnan(lesson.object.metres_per_pixel));
  EXPECT_NE(lesson.message.find("without scale"), std::string::npos) << lesson.message;
  EXPECT_FALSE(lesson.object.has_grasp);
  EXPECT_NE(lesson.message.find("marked before this demonstration"), std::string::npos)
      << "the grasp of SetUp(): " << lesson.message;
}

// Must be the last test, because later stamps are too old for tf.
TEST_F(LessonScale, ScaleAndGraspSurviveTheTfCacheTime) {
  const std::string id = begin(goal("long", pose_));
  place(ros::Time::now() + ros::Duration(60));
  const Result lesson = accept(id);
  EXPECT_NEAR(lesson.object.metres_per_pixel, kDistance / kFocalLength, 1e-6) << lesson.message;
  expect_grasp(lesson, {lesson.object.reference.x, lesson.object.reference.y}, 0);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "lesson_scale_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
