// SPDX-License-Identifier: BSD-3-Clause
// A tilted camera whose images are shown as seen from straight above.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "mbncc/geometry.hpp"
#include "nodelets/simulated_cell.hpp"

namespace mbncc::nodelets {
namespace {

constexpr int kPlaces = 4;
constexpr char kCamera[] = "camera_optical_frame";

class TopView : public SimulatedCell {
 protected:
  /// The pose of the found object relative to the truth at the next place, in the camera's frame.
  std::optional<Eigen::Isometry3d> offset_at_next_place() {
    order("camera/put_next");
    if (!spin_until([this] { return rests(true); })) return {};
    const ros::Time since = truth_->header.stamp;
    if (!spin_until([&] { return confirmed_since(since) != nullptr; })) return {};
    const DetectedObject object = *confirmed_since(since);
    EXPECT_EQ(found_->header.frame_id, std::string(kCamera) + "_top_view");
    EXPECT_TRUE(object.pose_valid);
    EXPECT_EQ(found_->message, "") << "no tilt is left";
    Eigen::Isometry3d found, truth;
    tf2::fromMsg(object.pose.pose, found);
    tf2::fromMsg(truth_->objects[0].pose.pose, truth);
    const auto T_camera_view = tf2::transformToEigen(
        tf_.lookupTransform(kCamera, found_->header.frame_id, found_->header.stamp));
    return truth.inverse() * T_camera_view * found;
  }

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_{tf_};
};

TEST_F(TopView, PosesOfATiltedCameraAreTrueUntilItIsMoved) {
  ASSERT_NO_FATAL_FAILURE(teach("part"));
  const auto first = offset_at_next_place();
  ASSERT_TRUE(first);
  for (int place = 1; place < kPlaces; ++place) {
    const auto offset = offset_at_next_place();
    ASSERT_TRUE(offset);
    EXPECT_LE((offset->translation() - first->translation()).norm(), 0.0005) << place;
    const Eigen::AngleAxisd turn(first->linear().transpose() * offset->linear());
    EXPECT_LE(to_degrees(turn.angle()), 0.15) << place;
  }

  auto moved = tf_.lookupTransform(kCamera, "platform", ros::Time(0));
  moved.transform.rotation = tf2::toMsg(
      Eigen::Quaterniond(Eigen::AngleAxisd((180 - 9) * kPi / 180, Eigen::Vector3d::UnitX())));
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(moved);
  EXPECT_TRUE(spin_until([this] { return found_->status == DetectedObjectArray::STALE; }))
      << "images of another direction are not taken for those of the first";
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "top_view_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
