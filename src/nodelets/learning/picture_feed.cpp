// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/picture_feed.hpp"

#include <ros/console.h>

#include "nodelets/conversion/images.hpp"

namespace mbncc::nodelets {

PictureFeed::PictureFeed(double still_time, int white_level)
    : white_level_(white_level), watch_(still_time), worker_([this] { work(); }) {}

PictureFeed::~PictureFeed() {
  mailbox_.close();
  worker_.join();
}

PictureFeed::View PictureFeed::look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  View view = view_;
  view.silence = std::chrono::duration<double>(std::chrono::steady_clock::now() - arrived_).count();
  return view;
}

std::optional<StillShot> PictureFeed::before_change() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return watch_.before_change();
}

void PictureFeed::work() {
  while (const auto image = mailbox_.take()) {
    try {
      watch(**image);
    } catch (const std::exception& error) {
      ROS_ERROR_THROTTLE(10, "watching the cell failed: %s", error.what());
      refuse(std::string("watching it failed: ") + error.what());
    }
  }
}

void PictureFeed::refuse(const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++view_.refused;
  view_.fault = fault;
  view_.newest_refused = true;
}

void PictureFeed::watch(const sensor_msgs::Image& image) {
  const Decoded decoded = decode_picture(image, white_level_);
  if (!decoded) return refuse(decoded.fault);
  const std::lock_guard<std::mutex> lock(mutex_);
  watch_.update(image.header.stamp.toSec(), decoded.picture);
  arrived_ = std::chrono::steady_clock::now();
  view_.any_picture = true;
  view_.newest_refused = false;
  view_.still = watch_.still();
  view_.header = image.header;
}

}  // namespace mbncc::nodelets
