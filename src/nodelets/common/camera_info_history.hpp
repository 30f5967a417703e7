// SPDX-License-Identifier: BSD-3-Clause
// Stores the last calibrations of a camera and finds the one that an image was taken with.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <chrono>
#include <deque>
#include <opencv2/core.hpp>

namespace mbncc::nodelets {

/// Not thread-safe.
class CameraInfoHistory {
 public:
  using Clock = std::chrono::steady_clock;

  /// A calibration expires `max_age` [s] after it was received.
  explicit CameraInfoHistory(double max_age) : max_age_(max_age) {}

  void add(const sensor_msgs::CameraInfoConstPtr& info, Clock::time_point now = Clock::now());
  void clear();

  /// The last received calibration; null if there is none or it has expired.
  sensor_msgs::CameraInfoConstPtr newest(Clock::time_point now = Clock::now()) const;

  /// The calibration of an image with this header and size: of those for its frame and size, the
  /// one with its stamp. Without one, null if the last image had one. If neither had, as from a
  /// camera that publishes camera_info less often than images, the last two before the image and
  /// the first after it must be equal; null if they differ, because the camera was calibrated or
  /// zoomed anew about then.
  sensor_msgs::CameraInfoConstPtr of_image(const std_msgs::Header& header, cv::Size size,
                                           Clock::time_point now = Clock::now());

  /// Whether the calibration of the image with this stamp is probably still to come: the last image
  /// had one of its own, and none of this image's stamp or later was received.
  bool is_awaited(const ros::Time& stamp) const;

 private:
  struct Received {
    sensor_msgs::CameraInfoConstPtr info;
    Clock::time_point at;
  };

  bool has_expired(const Received& received, Clock::time_point now) const;

  const std::chrono::duration<double> max_age_;
  std::deque<Received> received_;  // newest last
  bool paired_ = false;            // the last image had a calibration of its own
};

}  // namespace mbncc::nodelets
