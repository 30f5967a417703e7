// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/image_feed.hpp"

#include <ros/console.h>

#include "nodelets/conversion/images.hpp"

namespace mbncc::nodelets {

ImageFeed::ImageFeed(double still_time, int white_level)
    : white_level_(white_level), watch_(still_time), worker_([this] { work(); }) {}

ImageFeed::~ImageFeed() {
  mailbox_.close();
  worker_.join();
}

ImageFeed::State ImageFeed::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  State copy = state_;
  copy.silence = std::chrono::duration<double>(std::chrono::steady_clock::now() - arrived_).count();
  return copy;
}

std::optional<StillShot> ImageFeed::before_change() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return watch_.before_change();
}

void ImageFeed::work() {
  while (const auto message = mailbox_.take()) {
    try {
      watch(**message);
    } catch (const std::exception& error) {
      ROS_ERROR_THROTTLE(10, "processing the image failed: %s", error.what());
      refuse(std::string("processing the image failed: ") + error.what());
    }
  }
}

void ImageFeed::refuse(const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++state_.refused;
  state_.fault = fault;
  state_.newest_refused = true;
}

void ImageFeed::watch(const sensor_msgs::Image& message) {
  const Decoded decoded = decode_image(message, white_level_);
  if (!decoded) return refuse(decoded.fault);
  const std::lock_guard<std::mutex> lock(mutex_);
  watch_.update(message.header.stamp.toSec(), decoded.image);
  arrived_ = std::chrono::steady_clock::now();
  state_.any_image = true;
  state_.newest_refused = false;
  state_.still = watch_.still();
  state_.header = message.header;
}

}  // namespace mbncc::nodelets
