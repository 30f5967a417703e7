// SPDX-License-Identifier: BSD-3-Clause
// Live CHANGE lessons in the simulated cell, and searches for what was learned.
#include <gtest/gtest.h>
#include <mbncc_vision/EditObject.h>
#include <nodelet/NodeletUnload.h>
#include <ros/ros.h>

#include <cmath>

#include "mbncc/geometry.hpp"
#include "nodelets/call_service.hpp"
#include "nodelets/simulated_cell.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

class LiveLesson : public SimulatedCell {
 protected:
  // The next lesson teaches the same object; under two names, both would be ambiguous.
  void forget(const std::string& name) {
    mbncc_vision::EditObject edit;
    edit.request.name = name;
    edit.request.command = mbncc_vision::EditObject::Request::DELETE;
    EXPECT_TRUE(call_service("edit_object", edit) && edit.response.success);
  }

  void expect_found(const std::string& name, const Pose2D& reference_in_drawing) {
    ASSERT_TRUE(spin_until([this] { return rests(true); }));
    const ros::Time since = truth_->header.stamp;
    const DetectedObject* object = nullptr;
    ASSERT_TRUE(spin_until([&] { return (object = confirmed_since(since, name)) != nullptr; }))
        << "never confirmed";
    const auto& true_pose = truth_->objects[0].image_pose;
    const Pose2D expected =
        compose({true_pose.x, true_pose.y, true_pose.theta}, reference_in_drawing);
    EXPECT_LE(std::hypot(object->image_pose.x - expected.x, object->image_pose.y - expected.y), 1);
    EXPECT_LE(to_degrees(angle_distance(object->image_pose.theta, expected.theta)), 1);
    EXPECT_TRUE(object->pose_valid);
    EXPECT_NEAR(object->pose.pose.position.z, 0.6, 1e-6);
    EXPECT_NE(object->child_frame_id, "");
  }
};

Pose2D reference_in_drawing(const DetectedObject& lay, const Teacher::Result& lesson) {
  const auto& p = lay.image_pose;
  const auto& r = lesson.object.reference;
  return compose(inverse({p.x, p.y, p.theta}), {r.x, r.y, r.theta});
}

TEST_F(LiveLesson, TeachesFromTheRemovalAndFindsTheObjectElsewhere) {
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  ASSERT_TRUE(spin_until([this] { return rests(true); }));
  const DetectedObject lay = truth_->objects[0];
  Teacher::Goal goal;
  goal.name = "taken";
  const std::string id = teacher.send(goal);
  ASSERT_TRUE(spin_until([&] { return teacher.heard(id, Teacher::Feedback::WAIT_REMOVAL); }));
  order("camera/take_away");
  const auto lesson = teacher.await(id).result;
  ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
  EXPECT_NEAR(lesson.object.metres_per_pixel, 0.6 / 600, 1e-9);
  EXPECT_FALSE(lesson.preview.data.empty());
  EXPECT_EQ(lesson.map.width, lesson.template_image.width);

  order("camera/put_next");
  expect_found("taken", reference_in_drawing(lay, lesson));
  forget("taken");
}

TEST_F(LiveLesson, TeachesAnObjectThatHasBeenTakenAwayAlready) {
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  ASSERT_TRUE(spin_until([this] { return rests(true); }));
  // A still period with the object in view: a new lesson sees one before it asks for the removal.
  Teacher::Goal goal;
  goal.name = "waiting";
  const std::string waiting = teacher.send(goal);
  ASSERT_TRUE(spin_until([&] { return teacher.heard(waiting, Teacher::Feedback::WAIT_REMOVAL); }));
  teacher.cancel(waiting);
  EXPECT_EQ(teacher.await(waiting).status.status, actionlib_msgs::GoalStatus::PREEMPTED);
  const DetectedObject lay = truth_->objects[0];

  order("camera/take_away");
  ASSERT_TRUE(spin_until([this] { return rests(false); }));
  goal.name = "gone";
  goal.already_moved = true;
  const auto lesson = teacher.teach(goal);
  ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
  order("camera/put_next");
  expect_found("gone", reference_in_drawing(lay, lesson));
  forget("gone");
}

// This must be the last test, because it unloads the learning nodelet.
TEST_F(LiveLesson, InformsTheClientWhenTheNodeletIsUnloaded) {
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  Teacher::Goal goal;
  goal.name = "interrupted";
  const std::string id = teacher.send(goal);
  ASSERT_TRUE(spin_until([&] { return teacher.heard(id, Teacher::Feedback::WAIT_REMOVAL); }));
  nodelet::NodeletUnload unload;
  unload.request.name = ros::names::resolve("learning");
  ASSERT_TRUE(call_service("manager/unload_nodelet", unload));
  EXPECT_TRUE(unload.response.success);
  const auto end = teacher.await(id);
  EXPECT_EQ(end.status.status, actionlib_msgs::GoalStatus::ABORTED);
  EXPECT_EQ(end.result.error_code, Teacher::Result::CANCELLED);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "live_lesson_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
