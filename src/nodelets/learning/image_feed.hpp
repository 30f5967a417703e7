// SPDX-License-Identifier: BSD-3-Clause
// Live images of the cell, monitored for stillness on a separate thread.
#pragma once

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <thread>

#include "mbncc/cell/scene_watch.hpp"
#include "nodelets/common/mailbox.hpp"

namespace mbncc::nodelets {

/// An image to learn from, CV_8UC3.
struct LessonImage {
  cv::Mat image;
  std_msgs::Header header;
  std::uint64_t number = 0;  ///< of the still period, from 1; 0: given with the goal
};

class ImageFeed {
 public:
  /// The scene is still after `still_time` [s] without motion; `white_level` as in
  /// decode_image().
  explicit ImageFeed(double still_time, int white_level = 0);

  int white_level() const { return white_level_; }

  ~ImageFeed();

  /// Passes an image to the watch. Never blocks: a newer image replaces one that still waits.
  void put(const sensor_msgs::ImageConstPtr& image) { mailbox_.put(image); }

  /// State of the live scene.
  struct State {
    bool any_image = false;          ///< a usable image has arrived
    std::optional<StillShot> still;  ///< see SceneWatch::still()
    std_msgs::Header header;         ///< of the newest image
    double silence = 0;              ///< [s] since a usable image arrived, by the steady clock
    std::uint64_t refused = 0;       ///< images that could not be decoded or processed
    std::string fault;               ///< why the last refused image was refused
    bool newest_refused = false;     ///< the newest image was refused
  };
  State state() const;

  /// See SceneWatch::before_change(); it compares images, so do not poll it.
  std::optional<StillShot> before_change() const;

 private:
  void work();
  void watch(const sensor_msgs::Image& image);
  void refuse(const std::string& fault);

  const int white_level_;
  Mailbox<sensor_msgs::ImageConstPtr> mailbox_;
  mutable std::mutex mutex_;
  SceneWatch watch_;
  State state_;
  std::chrono::steady_clock::time_point arrived_;
  std::thread worker_;
};

}  // namespace mbncc::nodelets
