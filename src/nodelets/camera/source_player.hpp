// SPDX-License-Identifier: BSD-3-Clause
// Manages a camera's image source: opens it, plays it at its rate, and reopens it after a
// failure.
#pragma once

#include <ros/time.h>

#include <chrono>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "mbncc/cell/frozen_image.hpp"
#include "mbncc/config/camera_config.hpp"
#include "nodelets/camera/camera_health.hpp"
#include "nodelets/camera/image_source.hpp"

namespace mbncc::nodelets {

class SourcePlayer {
 public:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  /// Callbacks of a player, called only in step().
  struct Callbacks {
    /// Opens the source; throws FileError when it cannot be opened now.
    std::function<std::unique_ptr<ImageSource>()> open;
    std::function<bool()> has_listener;
    std::function<ros::Time()> time;  ///< for stamps; zero before a simulated clock has started
    std::function<Clock::time_point()> steady_time;  ///< for the rate
    std::function<void(Seconds)> pause;              ///< may return early to end the player
    /// Takes CV_8UC1 or CV_8UC3.
    std::function<void(const cv::Mat& image, const ros::Time& stamp)> publish;
  };

  SourcePlayer(const CameraConfig& config, Callbacks callbacks);

  /// Attempts once to open the source, plays one image, or pauses once. Errors are logged and
  /// reported by health(); the source is then reopened after a pause of 0.5 s, which doubles up to
  /// 8 s unless the source was opened and only repeats its last image.
  void step();

  /// May be called from any thread.
  CameraHealth& health() { return health_; }

 private:
  using Counts = CameraHealth::Counts;

  void try_step();
  void open();
  void close(const std::string& reason);
  bool has_new_stamp() const;
  void play();
  void end();
  cv::Mat retrieve();
  void refuse_frozen(const cv::Mat& image);
  void wait_until_due();

  const CameraConfig config_;
  const std::string name_;  // name of the source in messages
  const Callbacks callbacks_;
  CameraHealth health_;
  std::unique_ptr<ImageSource> source_;
  FrozenImage frozen_;  // also across openings: a camera may freeze for good
  Seconds retry_;
  Clock::time_point due_;
  ros::Time last_stamp_;
  bool at_end_ = false;
};

}  // namespace mbncc::nodelets
