// SPDX-License-Identifier: BSD-3-Clause
// Publishes the images of a device, stream, folder or video with their calibration.
#include <camera_info_manager/camera_info_manager.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "mbncc/config/camera_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/health_tasks.hpp"
#include "nodelets/camera/source_player.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"
#include "nodelets/common/parameters.hpp"
#include "nodelets/conversion/images.hpp"

namespace mbncc::nodelets {

class CameraNodelet : public GuardedNodelet {
 public:
  ~CameraNodelet() override { finish(); }

 private:
  void start() override;
  void stop() override;
  void start_calibration();
  SourcePlayer::Callbacks callbacks();

  void work();
  std::unique_ptr<ImageSource> open() const;
  void publish(const cv::Mat& image, const ros::Time& stamp);
  void pause(SourcePlayer::Seconds time);
  bool stopping();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  CameraConfig config_;
  image_transport::CameraPublisher camera_;
  std::unique_ptr<camera_info_manager::CameraInfoManager> calibration_;
  std::unique_ptr<SourcePlayer> player_;
  std::unique_ptr<HealthReport> report_;

  std::mutex mutex_;  // guards stopping_
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::thread worker_;
};

void CameraNodelet::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  stopped_.notify_all();
  report_.reset();
  if (worker_.joinable()) worker_.join();
}

void CameraNodelet::start() {
  read_parameters(private_node(), field_rows(config_));
  if (config_.source.empty())
    throw ConfigError(
        "parameter 'source' is empty; give a device index or path, a stream URL, a "
        "folder of images or a video file");
  start_calibration();
  image_transport::ImageTransport transport(node());
  camera_ = transport.advertiseCamera("image_raw", 5);
  player_ = std::make_unique<SourcePlayer>(config_, callbacks());
  report_ = std::make_unique<HealthReport>(node(), private_node(), getName(),
                                           without_secrets(config_.source), kImagesTask,
                                           [this](auto& status) { diagnose(status); });
  worker_ = std::thread(&CameraNodelet::work, this);
}

void CameraNodelet::start_calibration() {
  calibration_ = std::make_unique<camera_info_manager::CameraInfoManager>(node());
  if (!calibration_->setCameraName(config_.camera_name))
    throw ConfigError("parameter 'camera_name': value '" + config_.camera_name +
                      "' is not allowed; give letters, digits and underscores");
  if (!calibration_->validateURL(config_.camera_info_url))
    throw ConfigError("parameter 'camera_info_url': value '" + config_.camera_info_url +
                      "' is not allowed; give file:///... or package://... or leave it empty");
  calibration_->loadCameraInfo(config_.camera_info_url);
  if (!calibration_->isCalibrated())
    NODELET_WARN("No calibration of camera '%s': poses will be in pixels only",
                 config_.camera_name.c_str());
}

SourcePlayer::Callbacks CameraNodelet::callbacks() {
  return {
      [this] { return open(); },
      [this] { return camera_.getNumSubscribers() > 0; },
      [] { return ros::Time::now(); },
      [] { return SourcePlayer::Clock::now(); },
      [this](SourcePlayer::Seconds time) { pause(time); },
      [this](const cv::Mat& image, const ros::Time& stamp) { publish(image, stamp); },
  };
}

void CameraNodelet::work() {
  while (!stopping()) player_->step();
}

std::unique_ptr<ImageSource> CameraNodelet::open() const {
  std::vector<std::string> refused;
  auto source = open_image_source(config_, refused);
  for (const auto& sentence : refused) NODELET_WARN("%s", sentence.c_str());
  return source;
}

void CameraNodelet::publish(const cv::Mat& image, const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = config_.frame_id;
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>(calibration_->getCameraInfo());
  info->header = header;
  if (!calibration_->isCalibrated()) {
    info->width = static_cast<std::uint32_t>(image.cols);
    info->height = static_cast<std::uint32_t>(image.rows);
  }
  camera_.publish(boost::make_shared<sensor_msgs::Image>(encode_image(image, header)), info);
}

void CameraNodelet::pause(SourcePlayer::Seconds time) {
  std::unique_lock<std::mutex> lock(mutex_);
  stopped_.wait_for(lock, time, [this] { return stopping_; });
}

bool CameraNodelet::stopping() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

void CameraNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  player_->health().describe(status);
  status.add("listeners", camera_.getNumSubscribers());
  status.add("calibrated", calibration_->isCalibrated() ? "yes" : "no");
}

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::CameraNodelet, nodelet::Nodelet)
