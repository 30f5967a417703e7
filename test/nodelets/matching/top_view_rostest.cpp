// SPDX-License-Identifier: BSD-3-Clause
// A tilted camera whose images are shown as seen from straight above.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
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

  /// A second rectify nodelet, whose platform was calibrated with another focal length.
  void expect_no_view_of_another_camera() {
    ros::param::set("/other/top_view", true);
    ros::param::set("/other/platform_frame", "platform");
    ros::param::set("/other/platform_intrinsics",
                    "plumb_bob 480 360 341 341 239.5 179.5 -0.1 0 0 0 0");
    nodelet::Loader loader(false);
    ASSERT_TRUE(loader.load("/other", "mbncc_vision/RectifyNodelet",
                            {{"/image_raw", "/cell9/image_raw"},
                             {"/camera_info", "/cell9/camera_info"},
                             {"/top_view/image_rect", "/other/image_rect"},
                             {"/top_view/camera_info", "/other/camera_info"}},
                            {}));
    int views = 0;
    std::string fault;
    const auto images = node_.subscribe<sensor_msgs::Image>(
        "/other/image_rect", 10, [&](const sensor_msgs::Image::ConstPtr&) { ++views; });
    const auto reports = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 20, [&](const diagnostic_msgs::DiagnosticArray::ConstPtr& report) {
          for (const auto& status : report->status)
            if (status.level == status.ERROR) fault += status.name + ": " + status.message;
        });
    EXPECT_TRUE(spin_until([&] {
      return fault.find("measured with another calibration of the camera") != std::string::npos;
    })) << fault;
    EXPECT_EQ(views, 0);
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

  expect_no_view_of_another_camera();

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
