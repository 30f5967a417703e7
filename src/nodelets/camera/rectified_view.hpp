// SPDX-License-Identifier: BSD-3-Clause
// What the rectify nodelet makes of a camera's images: the same view without distortion, or the
// view from straight above.
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

/// From which images which ones are made, or why none.
struct RectifiedView {
  Lens lens;            ///< of the received images
  TurnedCamera wanted;  ///< of the published ones
  std::string frame_id;
  std::string fault;  ///< message with the remedy

  explicit operator bool() const { return fault.empty(); }
};

/// The camera of P, in the frame of the image.
RectifiedView without_distortion(const sensor_msgs::CameraInfo& info,
                                 const std_msgs::Header& header, cv::Size size);

/// The view of a fixed camera from straight above its platform. Its optical frame, named after the
/// camera's with `_top_view` appended, is sent as a static transform.
class TopView {
 public:
  /// Throws std::invalid_argument without a platform_frame.
  explicit TopView(const RectifyConfig& config);

  /// A fault if the platform's direction is unknown, or is no longer that of the first image: the
  /// frame is static, and a lesson compares images of one view.
  RectifiedView view(const sensor_msgs::CameraInfo& info, const std_msgs::Header& header,
                     cv::Size size);

 private:
  void send_frame(const std::string& camera, const RectifiedView& view);

  const RectifyConfig config_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_{tf_};
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  std::optional<cv::Vec3d> normal_;  // of the platform at the first image
};

}  // namespace mbncc::nodelets
