// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/rectified_view.hpp"

#include <tf2_eigen/tf2_eigen.h>

#include <cmath>
#include <exception>
#include <stdexcept>

#include "nodelets/conversion/calibration.hpp"
#include "nodelets/conversion/platform_intrinsics.hpp"
#include "nodelets/conversion/tf_wait.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kMoved = 0.1;  // [degrees] largest rotation of the platform's normal

double degrees_between(const cv::Vec3d& a, const cv::Vec3d& b) {
  return std::atan2(cv::norm(a.cross(b)), a.dot(b)) * 180 / CV_PI;
}

RectifiedView refused(const std::string& fault) {
  RectifiedView view;
  view.fault = fault;
  return view;
}

Lens received_lens(const sensor_msgs::CameraInfo& info, bool rectified) {
  if (!rectified) return lens_of(info);
  Lens lens;
  lens.camera = rectified_camera_of(info);
  return lens;
}

}  // namespace

RectifiedView without_distortion(const sensor_msgs::CameraInfo& info,
                                 const std_msgs::Header& header, cv::Size size) {
  std::string fault = fault_of_calibration(info, true, size);
  if (fault.empty()) {
    // Rectification applies R, so a rotation in R is no fault.
    sensor_msgs::CameraInfo unturned = info;
    unturned.R.fill(0);
    fault = fault_of_calibration(unturned, false, size);
  }
  if (!fault.empty()) return refused(fault);
  return {lens_of(info), {rectification_of(info), rectified_camera_of(info)}, header.frame_id, ""};
}

TopView::TopView(const RectifyConfig& config) : config_(config) {
  if (config.platform_frame.empty())
    throw std::invalid_argument(
        "top_view needs the platform's tf frame: set platform_frame, or start the cell with "
        "platform:= the folder that calibrate_platform wrote");
  check_platform_intrinsics(config.platform_intrinsics);
}

RectifiedView TopView::view(const sensor_msgs::CameraInfo& info, const std_msgs::Header& header,
                            cv::Size size) {
  const std::string camera = config_.camera_frame.empty() ? header.frame_id : config_.camera_frame;
  std::string fault = fault_of_calibration(info, config_.rectified, size);
  if (fault.empty()) fault = fault_of_platform_intrinsics(config_.platform_intrinsics, info);
  if (camera.empty())
    fault = "the images have no frame_id; let the camera set header.frame_id, or set camera_frame";
  if (!fault.empty()) return refused(fault);
  try {
    const Plane platform = plane_of(
        tf2::transformToEigen(tf_.lookupTransform(camera, config_.platform_frame, header.stamp)));
    if (normal_ && degrees_between(*normal_, platform.normal) > kMoved)
      return refused(
          "platform: its direction in the camera's frame has changed; a top view needs a fixed "
          "camera: start the cell again after a new calibration, or with top_view:=false for a "
          "camera on the robot");
    RectifiedView view{received_lens(info, config_.rectified), {}, camera + "_top_view", ""};
    view.wanted =
        top_view(view.lens.camera, {platform.point, normal_.value_or(platform.normal)}, size);
    if (!normal_) send_frame(camera, view);
    normal_ = normal_.value_or(platform.normal);
    return view;
  } catch (const tf2::TransformException& error) {
    return refused("platform: " + tf_fault(error));
  } catch (const std::exception& error) {
    return refused(std::string("platform: ") + error.what());
  }
}

void TopView::send_frame(const std::string& camera, const RectifiedView& view) {
  const cv::Matx33d& r = view.wanted.rotation;
  Eigen::Isometry3d T_camera_top_view = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      T_camera_top_view.linear()(row, column) = r(column, row);
  geometry_msgs::TransformStamped transform = tf2::eigenToTransform(T_camera_top_view);
  transform.header.stamp = ros::Time::now();
  transform.header.frame_id = camera;
  transform.child_frame_id = view.frame_id;
  broadcaster_.sendTransform(transform);
}

}  // namespace mbncc::nodelets
