// SPDX-License-Identifier: BSD-3-Clause
// image_raw and camera_info, subscribed to while somebody needs them.
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// Said when publishers() is 0.
constexpr char kNobodyPublishes[] =
    "nobody publishes pictures; start the camera, or check the image topic";

/// Said when no picture has come for a while.
constexpr char kPicturesStopped[] = "pictures have stopped; check the camera and its cable";

/// Said when camera_info_for() is null.
constexpr char kNoCameraInfo[] =
    "no camera_info of this picture's size and frame has come within max_info_age; check its topic";

class CameraInput {
 public:
  using Callback = std::function<void(const sensor_msgs::ImageConstPtr&)>;

  /// `transport`: raw, compressed ...; where its plugin is not installed that is said once, no
  /// picture comes, and fault() tells why. Pictures reach `callback` on the node's callback thread.
  /// A calibration counts for `max_info_age` [s] of the steady clock after it came.
  CameraInput(ros::NodeHandle node, const std::string& transport, double max_info_age,
              Callback callback);

  /// Subscribes or unsubscribes as `wanted` says; does nothing when that is so already. Of calls
  /// from several threads the last one's word holds.
  void set_active(const std::function<bool()>& wanted);
  void set_active(bool active) {
    set_active([active] { return active; });
  }

  /// Number of publishers of the picture topic.
  std::uint32_t publishers() const;

  /// What is wrong with the stream of pictures, with the remedy: they cannot be subscribed to,
  /// nobody publishes them, or they have stopped. "" when they come, or are not subscribed to.
  std::string fault() const;

  /// Calibration as last heard of; null: none that counts.
  sensor_msgs::CameraInfoConstPtr camera_info() const;

  /// The same for pictures of this size and frame.
  sensor_msgs::CameraInfoConstPtr camera_info_for(const std::string& frame_id, cv::Size size) const;

 private:
  using Clock = std::chrono::steady_clock;

  void subscribe();
  void subscribe_to_images();
  void unsubscribe();
  void note_image();

  ros::NodeHandle node_;
  image_transport::ImageTransport transport_;
  const std::string transport_name_;
  const std::chrono::duration<double> max_info_age_;
  const Callback callback_;
  std::mutex switching_;  // of active_; taken before mutex_, and by no picture's callback
  bool active_ = false;
  mutable std::mutex mutex_;  // of what follows
  std::string transport_fault_;
  image_transport::Subscriber images_;
  ros::Subscriber infos_;
  sensor_msgs::CameraInfoConstPtr info_;
  Clock::time_point info_came_, image_came_;
};

}  // namespace mbncc::nodelets
