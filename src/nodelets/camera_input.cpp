#include "nodelets/camera_input.hpp"

#include <utility>

namespace mbncc::nodelets {

CameraInput::CameraInput(ros::NodeHandle node, const std::string& transport, Callback callback)
    : node_(std::move(node)),
      transport_(node_),
      transport_name_(transport),
      callback_(std::move(callback)) {}

void CameraInput::set_active(const std::function<bool()>& wanted) {
  const std::lock_guard<std::mutex> switching(switching_);
  const bool active = wanted();
  if (active == this->active()) return;
  active ? subscribe() : unsubscribe();
}

void CameraInput::unsubscribe() {
  image_transport::Subscriber images;
  ros::Subscriber infos;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(images, images_);
    std::swap(infos, infos_);
    info_.reset();
  }
  // Waits for a callback that is running, which may be waiting for the mutex.
  images.shutdown();
  infos.shutdown();
}

void CameraInput::subscribe() {
  const std::lock_guard<std::mutex> lock(mutex_);
  infos_ = node_.subscribe<sensor_msgs::CameraInfo>(
      "camera_info", 1, [this](const sensor_msgs::CameraInfoConstPtr& info) {
        const std::lock_guard<std::mutex> info_lock(mutex_);
        info_ = info;
      });
  images_ = transport_.subscribe(
      "image_raw", 1, [this](const sensor_msgs::ImageConstPtr& image) { callback_(image); },
      ros::VoidPtr(), image_transport::TransportHints(transport_name_));
}

bool CameraInput::active() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<bool>(images_);
}

std::uint32_t CameraInput::publishers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return images_ ? images_.getNumPublishers() : 0;
}

sensor_msgs::CameraInfoConstPtr CameraInput::camera_info() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return info_;
}

sensor_msgs::CameraInfoConstPtr CameraInput::camera_info_for(
    const sensor_msgs::Image& image) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool fits = info_ && info_->width == image.width && info_->height == image.height &&
                    info_->header.frame_id == image.header.frame_id;
  return fits ? info_ : nullptr;
}

}  // namespace mbncc::nodelets
