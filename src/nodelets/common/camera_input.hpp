// SPDX-License-Identifier: BSD-3-Clause
// Subscribes to image_raw and camera_info while they are needed.
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <opencv2/core.hpp>
#include <string>

#include "nodelets/common/camera_info_history.hpp"

namespace mbncc::nodelets {

/// Message if no image has arrived for some time.
constexpr char kNoImages[] = "no images arrive; check the camera and its cable";

struct CameraInputConfig {
  std::string transport;    ///< raw, compressed ...
  double max_info_age = 0;  ///< [s] by the steady clock, age at which a calibration expires
  int queue_size = 1;       ///< images that may wait for the callback
};

class CameraInput {
 public:
  using Callback = std::function<void(const sensor_msgs::ImageConstPtr&)>;

  /// If the transport's plugin is not installed, this is logged once, no image arrives, and
  /// fault() gives the reason. Images are passed to `callback` on the node's callback thread.
  CameraInput(ros::NodeHandle node, CameraInputConfig config, Callback callback);

  /// Subscribes or unsubscribes according to `wanted`; does nothing if unchanged. `wanted` is
  /// evaluated under a lock, so the last of several calls from different threads decides.
  void set_active(const std::function<bool()>& wanted);
  void set_active(bool active) {
    set_active([active] { return active; });
  }

  /// Number of publishers of the image topic.
  std::uint32_t publishers() const;

  /// The fault of the image stream, with the remedy: no transport plugin, no publisher, or
  /// images have stopped. "" if images arrive or are not subscribed to.
  std::string fault() const;

  /// The last received calibration; null if none is valid.
  sensor_msgs::CameraInfoConstPtr camera_info() const;

  /// The calibration of an image with this header and size, as CameraInfoHistory::of_image() finds
  /// it; null if there is none. Waits up to 50 ms for it, because drivers publish the image first.
  /// Do not call this on the thread that receives calibrations.
  sensor_msgs::CameraInfoConstPtr camera_info_for(const std_msgs::Header& header, cv::Size size);

 private:
  using Clock = std::chrono::steady_clock;

  void subscribe();
  void subscribe_to_images();
  void unsubscribe();
  void on_image_received();

  ros::NodeHandle node_;
  image_transport::ImageTransport transport_;
  const CameraInputConfig config_;
  const Callback callback_;
  std::mutex switching_;  // guards active_; locked before mutex_, and never in an image callback
  bool active_ = false;
  std::condition_variable info_received_;
  mutable std::mutex mutex_;  // guards the members below
  std::string transport_fault_;
  image_transport::Subscriber images_;
  ros::Subscriber infos_;
  CameraInfoHistory history_;
  Clock::time_point image_received_;
};

}  // namespace mbncc::nodelets
