// SPDX-License-Identifier: BSD-3-Clause
// Stores the last calibrations of a camera and finds the one that an image was taken with.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <chrono>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace mbncc::nodelets {

/// Not thread-safe.
class CameraInfoHistory {
 public:
  using Clock = std::chrono::steady_clock;

  /// A calibration expires `max_age` [s] after it was received.
  explicit CameraInfoHistory(double max_age) : max_age_(max_age) {}

  /// If the stamps of a frame and size go back by more than 50 ms, as after the clock was set back,
  /// those that are later are discarded: they are of before.
  void add(const sensor_msgs::CameraInfoConstPtr& info, Clock::time_point now = Clock::now());
  void clear();

  /// The last received calibration; null if there is none or it has expired.
  sensor_msgs::CameraInfoConstPtr newest(Clock::time_point now = Clock::now()) const;

  /// The calibration of an image with this header and size: of those for its frame and size, the
  /// one with its stamp. Without one, although each of the last three images had one, null for a
  /// second. Otherwise, as from a camera that publishes camera_info less often than images, the
  /// last two before the image and the first after it must be equal; null if they differ, because
  /// the camera was calibrated or zoomed anew about then. The newest one counts alone after 2 s.
  sensor_msgs::CameraInfoConstPtr of_image(const std_msgs::Header& header, cv::Size size,
                                           Clock::time_point now = Clock::now());

  /// Whether the calibration of the image with this stamp is probably still to come: each of the
  /// last three images had one of its own, and none of this image's stamp or later was received.
  bool is_awaited(const ros::Time& stamp) const;

 private:
  struct Received {
    sensor_msgs::CameraInfoConstPtr info;
    Clock::time_point at;
  };

  bool has_expired(const Received& received, Clock::time_point now) const;
  void note_pair(const ros::Time& stamp);
  bool lacks_its_own(Clock::time_point now);
  static sensor_msgs::CameraInfoConstPtr of_neighbours(const std::vector<Received>& fitting,
                                                       const ros::Time& stamp,
                                                       Clock::time_point now);

  const std::chrono::duration<double> max_age_;
  std::deque<Received> received_;  // newest last
  int pairs_ = 0;                  // successive images with a calibration of their own
  ros::Time last_pair_;            // stamp of the last one
  std::optional<Clock::time_point> lacking_since_;  // the first image after them that had none
};

}  // namespace mbncc::nodelets
