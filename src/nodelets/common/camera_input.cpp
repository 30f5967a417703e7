// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/camera_input.hpp"

#include <ros/console.h>

#include <cstdint>
#include <utility>

namespace mbncc::nodelets {
namespace {

constexpr std::chrono::seconds kImageTimeout{5};  // longest gap between images
constexpr std::chrono::milliseconds kInfoWait{50};
constexpr std::uint32_t kWaitingInfos = 10;  // calibrations that may wait for the callback

std::string nobody_publishes(const std::string& topic) {
  return "no publisher of images on " + topic + "; start the camera, or check the image topic";
}

}  // namespace

CameraInput::CameraInput(ros::NodeHandle node, CameraInputConfig config, Callback callback)
    : node_(std::move(node)),
      transport_(node_),
      config_(std::move(config)),
      callback_(std::move(callback)),
      history_(config_.max_info_age) {}

void CameraInput::set_active(const std::function<bool()>& wanted) {
  const std::lock_guard<std::mutex> switching(switching_);
  const bool active = wanted();
  if (active == active_) return;
  active_ = active;
  active ? subscribe() : unsubscribe();
}

void CameraInput::unsubscribe() {
  image_transport::Subscriber images;
  ros::Subscriber infos;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(images, images_);
    std::swap(infos, infos_);
  }
  // Waits for a running callback, which may be waiting for the mutex.
  images.shutdown();
  infos.shutdown();
  const std::lock_guard<std::mutex> lock(mutex_);
  history_.clear();
}

void CameraInput::subscribe() {
  const std::lock_guard<std::mutex> lock(mutex_);
  infos_ = node_.subscribe<sensor_msgs::CameraInfo>(
      "camera_info", kWaitingInfos, [this](const sensor_msgs::CameraInfoConstPtr& info) {
        const std::lock_guard<std::mutex> info_lock(mutex_);
        history_.add(info);
        info_received_.notify_all();
      });
  image_received_ = Clock::now();
  if (transport_fault_.empty()) subscribe_to_images();
}

void CameraInput::subscribe_to_images() {
  try {
    images_ = transport_.subscribe(
        "image_raw", config_.queue_size,
        [this](const sensor_msgs::ImageConstPtr& image) {
          on_image_received();
          callback_(image);
        },
        ros::VoidPtr(), image_transport::TransportHints(config_.transport));
  } catch (const image_transport::Exception&) {
    transport_fault_ = "no plugin for image_transport '" + config_.transport +
                       "' is installed here; install " + config_.transport +
                       "_image_transport, or set image_transport to raw";
    ROS_ERROR("%s: %s", node_.resolveName("image_raw").c_str(), transport_fault_.c_str());
  }
}

std::uint32_t CameraInput::publishers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return images_ ? images_.getNumPublishers() : 0;
}

void CameraInput::on_image_received() {
  const std::lock_guard<std::mutex> lock(mutex_);
  image_received_ = Clock::now();
}

std::string CameraInput::fault() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!transport_fault_.empty()) return transport_fault_;
  if (!images_) return "";
  if (images_.getNumPublishers() == 0) return nobody_publishes(images_.getTopic());
  return Clock::now() - image_received_ > kImageTimeout ? kNoImages : "";
}

sensor_msgs::CameraInfoConstPtr CameraInput::camera_info() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return history_.newest();
}

sensor_msgs::CameraInfoConstPtr CameraInput::camera_info_for(const std_msgs::Header& header,
                                                             cv::Size size) {
  std::unique_lock<std::mutex> lock(mutex_);
  info_received_.wait_for(lock, kInfoWait, [&] { return !history_.is_awaited(header.stamp); });
  return history_.of_image(header, size);
}

}  // namespace mbncc::nodelets
