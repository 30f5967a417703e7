// SPDX-License-Identifier: BSD-3-Clause
// Determines the view that the rectify nodelet publishes: that of the received images without
// distortion, or the view from straight above.
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/cell/top_view.hpp"
#include "mbncc/config/rectify_config.hpp"
#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {

/// Cameras of the received and the published images, or the reason why nothing is published.
struct RectifiedView {
  Lens lens;            ///< lens of the received images
  TurnedCamera wanted;  ///< camera of the published images
  std::string frame_id;
  std::string fault;  ///< message with the remedy

  explicit operator bool() const { return fault.empty(); }
};

/// The view of the camera described by P, in the frame of the image.
RectifiedView without_distortion(const sensor_msgs::CameraInfo& info,
                                 const std_msgs::Header& header, cv::Size size);

/// The view of a fixed camera from straight above its platform. Its optical frame, named after the
/// camera's with `_top_view` appended, is sent as a static transform.
class TopView {
 public:
  /// Throws std::invalid_argument without a platform_frame, ConfigError for invalid
  /// platform_intrinsics.
  explicit TopView(const RectifyConfig& config);

  /// The view for an image of `size`. It has a fault if the platform was calibrated with another
  /// camera, or if its direction is unknown or differs from that in the first image: the frame is
  /// static, and a lesson compares images of one view.
  RectifiedView view(const sensor_msgs::CameraInfo& info, const std_msgs::Header& header,
                     cv::Size size);

 private:
  void send_frame(const std::string& camera, const RectifiedView& view);

  const RectifyConfig config_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_{tf_};
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  std::optional<cv::Vec3d> normal_;  // normal of the platform in the first image
};

}  // namespace mbncc::nodelets
