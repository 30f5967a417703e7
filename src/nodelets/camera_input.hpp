// image_raw and camera_info, subscribed to while somebody needs them.
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <mutex>
#include <string>

namespace mbncc::nodelets {

/// Said when publishers() is 0.
constexpr char kNobodyPublishes[] =
    "nobody publishes pictures; start the camera, or check the image topic";

class CameraInput {
 public:
  using Callback = std::function<void(const sensor_msgs::ImageConstPtr&)>;

  /// `transport`: raw, compressed ... Pictures reach `callback` on the node's callback thread.
  CameraInput(ros::NodeHandle node, const std::string& transport, Callback callback);

  /// Subscribes or unsubscribes as `wanted` says; does nothing when that is so already. Of calls
  /// from several threads the last one's word holds.
  void set_active(const std::function<bool()>& wanted);
  void set_active(bool active) {
    set_active([active] { return active; });
  }

  /// Number of publishers of the picture topic.
  std::uint32_t publishers() const;

  /// Calibration as last heard of; null: none.
  sensor_msgs::CameraInfoConstPtr camera_info() const;

  /// Calibration of this picture's size and frame as last heard of; null: none.
  sensor_msgs::CameraInfoConstPtr camera_info_for(const sensor_msgs::Image& image) const;

 private:
  bool active() const;
  void subscribe();
  void unsubscribe();

  ros::NodeHandle node_;
  image_transport::ImageTransport transport_;
  const std::string transport_name_;
  const Callback callback_;
  std::mutex switching_;      // taken before mutex_, and by no picture's callback
  mutable std::mutex mutex_;  // of what follows
  image_transport::Subscriber images_;
  ros::Subscriber infos_;
  sensor_msgs::CameraInfoConstPtr info_;
};

}  // namespace mbncc::nodelets
