// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/object_frames.hpp"

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace mbncc::nodelets {
namespace {

mbncc_vision::DetectedObject confirmed(std::uint32_t id, double x) {
  mbncc_vision::DetectedObject object;
  object.name = "key";
  object.instance_id = id;
  object.pose_valid = true;
  object.pose.pose.position.x = x;
  object.pose.pose.orientation.w = 1;
  object.child_frame_id = "object_key_" + std::to_string(id);
  object.stable_frame_id = "object_key";
  return object;
}

class ObjectFramesTest : public ::testing::Test {
 protected:
  /// Sends the frames for an image stamped `stamp` [s].
  void show(double stamp, const std::vector<mbncc_vision::DetectedObject>& objects) {
    mbncc_vision::DetectedObjectArray array;
    array.header.stamp.fromSec(stamp);
    array.header.frame_id = "camera";
    array.objects = objects;
    for (auto& transform : frames_.transforms_of(array)) {
      ++sent_;
      if (rounds_) transform.header.stamp.fromSec(transform.header.stamp.toSec());
      ASSERT_TRUE(buffer_.setTransform(transform, "test"));
    }
  }

  double x_at(const std::string& frame, double stamp) const {
    return buffer_.lookupTransform("camera", frame, ros::Time(stamp)).transform.translation.x;
  }

  ObjectFrames frames_;
  tf2::BufferCore buffer_;
  int sent_ = 0;
  bool rounds_ = false;  // rounds stamps to doubles, as Python's tf2 does
};

TEST_F(ObjectFramesTest, TheStableFrameFollowsOneInstanceBesideTheNumberedOnes) {
  mbncc_vision::DetectedObject other = confirmed(2, 5);
  other.stable_frame_id.clear();
  show(1, {confirmed(1, 3), other});
  EXPECT_EQ(x_at("object_key", 1), 3);
  EXPECT_EQ(x_at("object_key_1", 1), 3);
  EXPECT_EQ(x_at("object_key_2", 1), 5);
}

TEST_F(ObjectFramesTest, NoLookUpFindsTheStableFrameBetweenTwoInstances) {
  show(1, {confirmed(1, 3)});
  show(2, {confirmed(1, 3)});
  show(4, {confirmed(2, 7)});
  EXPECT_EQ(x_at("object_key", 1.5), 3);
  for (const double stamp : {2.001, 2.5, 3., 3.999, 4.})
    EXPECT_NEAR(x_at("object_key", stamp), 7, 1e-9) << stamp;
}

TEST_F(ObjectFramesTest, NeitherDoesALookUpInPythonWhoseStampsAreDoubles) {
  rounds_ = true;
  for (const double start : {1764000000.1, 1764000000.2, 1764000000.3}) {
    show(start, {confirmed(1, 3)});
    show(start + 0.03, {confirmed(2, 7)});
    EXPECT_NEAR(x_at("object_key", start + 0.015), 7, 1e-9) << start;
    frames_.reset();
    buffer_.clear();
  }
}

TEST_F(ObjectFramesTest, AnInstanceThatMovesIsInterpolated) {
  show(1, {confirmed(1, 3)});
  show(2, {confirmed(1, 4)});
  EXPECT_NEAR(x_at("object_key", 1.5), 3.5, 1e-9);
}

TEST_F(ObjectFramesTest, ATransformIsSentOncePerStampAndOnlyWithAName) {
  show(1, {confirmed(1, 3)});
  EXPECT_EQ(sent_, 2);
  show(1, {confirmed(1, 3)});
  show(0.5, {confirmed(1, 3)});
  mbncc_vision::DetectedObject nameless = confirmed(1, 3);
  nameless.child_frame_id.clear();
  nameless.stable_frame_id.clear();
  show(4, {nameless});
  EXPECT_EQ(sent_, 2);
  frames_.reset();
  show(0.5, {confirmed(1, 3)});
  EXPECT_EQ(sent_, 4);
}

TEST_F(ObjectFramesTest, AGraspIsAChildOfBothFrames) {
  mbncc_vision::DetectedObject turned = confirmed(1, 3);  // by 180 degrees about its x axis
  turned.pose.pose.orientation.x = 1;
  turned.pose.pose.orientation.w = 0;
  turned.has_grasp = true;
  turned.grasp.position.x = 3;
  turned.grasp.position.y = 0.1;
  turned.grasp.orientation.w = 1;
  show(1, {turned});
  for (const std::string frame : {"object_key", "object_key_1"}) {
    EXPECT_EQ(x_at(frame + "_grasp", 1), 3);
    const auto grasp = buffer_.lookupTransform(frame, frame + "_grasp", ros::Time(1)).transform;
    EXPECT_NEAR(grasp.translation.y, -0.1, 1e-9);
    EXPECT_NEAR(std::abs(grasp.rotation.x), 1, 1e-9);
  }
}

TEST_F(ObjectFramesTest, AnInvalidGraspGetsNoFrame) {
  mbncc_vision::DetectedObject object = confirmed(1, 3);
  object.has_grasp = true;
  object.grasp.position.x = std::numeric_limits<double>::quiet_NaN();
  show(1, {object});
  EXPECT_EQ(sent_, 2);
}

}  // namespace
}  // namespace mbncc::nodelets
