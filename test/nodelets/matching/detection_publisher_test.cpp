// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/detection_publisher.hpp"

#include <gtest/gtest.h>

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

DetectedObjectArray three_objects() {
  DetectedObjectArray array;
  array.header.frame_id = "base";
  for (const std::uint8_t state :
       {DetectedObject::CONFIRMED, DetectedObject::AMBIGUOUS, DetectedObject::CONFIRMED}) {
    DetectedObject object;
    object.state = state;
    object.pose_valid = true;
    object.pose.pose.position.x = static_cast<double>(array.objects.size());
    array.objects.push_back(object);
  }
  return array;
}

TEST(ConfirmedPoses, AreThoseOfGraspableObjectsInOrder) {
  const auto poses = confirmed_poses(three_objects());
  EXPECT_EQ(poses.header.frame_id, "base");
  ASSERT_EQ(poses.poses.size(), 2u);
  EXPECT_EQ(poses.poses[0].position.x, 0);
  EXPECT_EQ(poses.poses[1].position.x, 2);
}

TEST(ConfirmedPoses, AreInMetres) {
  auto array = three_objects();
  array.objects[0].pose_valid = false;
  EXPECT_EQ(confirmed_poses(array).poses.size(), 1u);
}

TEST(ConfirmedPoses, AreEmptyIfTheStatusForbidsMotion) {
  auto array = three_objects();
  array.status = DetectedObjectArray::BUDGET_EXCEEDED;
  EXPECT_EQ(confirmed_poses(array).poses.size(), 2u);
  for (const int status : {1, 2, 4, 5, 6, 200}) {
    array.status = static_cast<std::uint8_t>(status);
    EXPECT_TRUE(confirmed_poses(array).poses.empty()) << status;
  }
}

}  // namespace
}  // namespace mbncc::nodelets
