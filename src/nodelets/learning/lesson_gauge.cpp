// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_gauge.hpp"

#include <stdexcept>

#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {
namespace {

/// The object's pose in the frame in which grasps are marked: platform_frame, or the camera's frame
/// if that is not set.
Eigen::Isometry3d in_base(const Calibration& calibration, const PlatformPose& object) {
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    T_camera_object.translation()(row) = object.position[row];
    for (int column = 0; column < 3; ++column)
      T_camera_object.linear()(row, column) = object.rotation(row, column);
  }
  if (!calibration.T_camera_platform) return T_camera_object;
  return calibration.T_camera_platform->inverse() * T_camera_object;
}

}  // namespace

LessonGauge::LessonGauge(const PlatformConfig& config, const std::string& gripper_frame,
                         CameraInput& camera, const tf2_ros::Buffer& tf)
    : config_(config), camera_(camera), tf_(tf), mark_(tf, gripper_frame) {}

void LessonGauge::mark(const std_msgs::Header& newest_image) {
  const auto info = camera_.camera_info();
  std_msgs::Header header = newest_image;
  // The newest transform is enough to check that there is a platform; the lesson uses the stamp of
  // its image.
  header.stamp = ros::Time(0);
  const cv::Size size = info ? image_size(*info) : cv::Size();
  const Calibration calibration = calibrate(config_, info.get(), header, size, tf_);
  if (!calibration.platform)
    throw std::runtime_error("no grasp can be marked without scale: " + calibration.fault);
  // Relative to the platform, the grasp stays valid if the camera moves after its image.
  const bool on_platform = !config_.platform_frame.empty();
  mark_.record(on_platform ? config_.platform_frame : camera_frame_of(config_, header),
               ros::Time::now());
}

Calibration LessonGauge::calibrate_image(const sensor_msgs::CameraInfo& given,
                                         const std_msgs::Header& header, cv::Size size) const {
  const auto live = camera_.camera_info_for(header, size);
  return calibrate(config_, given.width != 0 ? &given : live.get(), header, size, tf_);
}

LessonMeasures LessonGauge::measure(const Calibration& calibration, const ros::Time& since,
                                    const Pose2D& reference, double object_height) const {
  LessonMeasures measures;
  if (!has_platform(config_)) return measures;
  measures.marked = mark_.is_marked_since(since);
  measures.marked_earlier = !measures.marked && mark_.is_marked();
  measures.fault = calibration.fault;
  if (!calibration.platform) return measures;
  const auto scale = calibration.platform->metres_per_pixel(reference.position(), object_height);
  const auto pose = calibration.platform->lift(reference, {}, object_height);
  if (!scale || !pose) {
    measures.fault = "the object's reference point does not lie on the platform";
    return measures;
  }
  measures.metres_per_pixel = *scale;
  if (measures.marked) measures.grasp = mark_.relative_to(in_base(calibration, *pose));
  return measures;
}

}  // namespace mbncc::nodelets
