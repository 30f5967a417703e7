// SPDX-License-Identifier: BSD-3-Clause
// A frame is sent only for objects that may be grasped.
#include "nodelets/matching/frame_permission.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

DetectedObjectArray graspable_one() {
  DetectedObject object;
  object.state = DetectedObject::CONFIRMED;
  object.pose_valid = true;
  object.pose.pose.orientation.w = 1;
  object.child_frame_id = "object_key_0";
  object.stable_frame_id = "object_key";
  DetectedObjectArray array;
  array.status = DetectedObjectArray::OK;
  array.objects.push_back(object);
  return array;
}

/// The remaining frames, joined into one string.
std::string frames_left(DetectedObjectArray array, bool wanted = true) {
  permit_frames(array, ros::Time(), wanted);
  return array.objects[0].child_frame_id + array.objects[0].stable_frame_id;
}

TEST(FramePermission, AllowsFramesForGraspableObjects) {
  EXPECT_EQ(frames_left(graspable_one()), "object_key_0object_key");
  DetectedObjectArray late = graspable_one();
  late.status = DetectedObjectArray::BUDGET_EXCEEDED;
  EXPECT_EQ(frames_left(late), "object_key_0object_key");
}

TEST(FramePermission, RefusesFramesForAllOtherObjects) {
  EXPECT_EQ(frames_left(graspable_one(), false), "") << "not wanted";
  for (const auto status :
       {DetectedObjectArray::STALE, DetectedObjectArray::UNCALIBRATED,
        DetectedObjectArray::TF_UNAVAILABLE, DetectedObjectArray::SEARCH_FAILED}) {
    DetectedObjectArray array = graspable_one();
    array.status = status;
    EXPECT_EQ(frames_left(array), "") << int(status);
  }
  for (const auto state : {DetectedObject::NEW, DetectedObject::AMBIGUOUS}) {
    DetectedObjectArray array = graspable_one();
    array.objects[0].state = state;
    EXPECT_EQ(frames_left(array), "") << int(state);
  }
  DetectedObjectArray pixels = graspable_one();
  pixels.objects[0].pose_valid = false;
  EXPECT_EQ(frames_left(pixels), "");
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  DetectedObjectArray nowhere = graspable_one();
  nowhere.objects[0].pose.pose.position.y = kNaN;
  EXPECT_EQ(frames_left(nowhere), "");
  DetectedObjectArray unturned = graspable_one();
  unturned.objects[0].pose.pose.orientation.z = kNaN;
  EXPECT_EQ(frames_left(unturned), "");
}

TEST(FramePermission, ChecksEachObjectSeparately) {
  DetectedObjectArray array = graspable_one();
  array.objects.push_back(array.objects[0]);
  array.objects[0].state = DetectedObject::NEW;
  permit_frames(array, ros::Time(), true);
  EXPECT_EQ(array.objects[0].child_frame_id, "");
  EXPECT_EQ(array.objects[1].child_frame_id, "object_key_0");
}

TEST(FramePermission, RefusesFramesForObjectsThatBecameTooOld) {
  DetectedObjectArray array = graspable_one();
  array.header.stamp = ros::Time(100);
  array.objects.push_back(array.objects[0]);
  array.objects[0].valid_until = ros::Time(100.5);
  array.objects[1].valid_until = ros::Time(100.2);
  permit_frames(array, ros::Time(100.3), true);
  EXPECT_NEAR(array.latency, 0.3, 1e-6);
  EXPECT_EQ(array.objects[0].state, DetectedObject::CONFIRMED);
  EXPECT_EQ(array.objects[0].child_frame_id, "object_key_0");
  EXPECT_EQ(array.objects[1].state, DetectedObject::NEW);
  EXPECT_EQ(array.objects[1].child_frame_id, "");
}

}  // namespace
}  // namespace mbncc::nodelets
