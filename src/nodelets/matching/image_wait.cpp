// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/image_wait.hpp"

#include <chrono>

namespace mbncc::nodelets {

void ImageWait::offer(const sensor_msgs::ImageConstPtr& image) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_ == 0) return;
  newest_ = image;
  offered_.notify_all();
}

void ImageWait::enter() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++waiting_;
}

void ImageWait::leave() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (--waiting_ == 0) newest_.reset();
}

bool ImageWait::wanted() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_ > 0;
}

sensor_msgs::ImageConstPtr ImageWait::next(const ros::Time& after, double timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto fits = [&] { return newest_ && newest_->header.stamp > after; };
  offered_.wait_for(lock, std::chrono::duration<double>(timeout),
                    [&] { return closed_ || fits(); });
  return !closed_ && fits() ? newest_ : nullptr;
}

void ImageWait::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  offered_.notify_all();
}

}  // namespace mbncc::nodelets
