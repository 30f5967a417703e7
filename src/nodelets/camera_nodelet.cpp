// Publishes the pictures of a device, stream, folder or video with their calibration.
#include <camera_info_manager/camera_info_manager.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "mbncc/cell/frozen_picture.hpp"
#include "mbncc/config/camera_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/health_tasks.hpp"
#include "nodelets/camera_health.hpp"
#include "nodelets/guarded_nodelet.hpp"
#include "nodelets/health_report.hpp"
#include "nodelets/images.hpp"
#include "nodelets/parameters.hpp"
#include "nodelets/picture_source.hpp"

namespace mbncc::nodelets {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kFirstRetry{0.5}, kLongestRetry{8};  // doubling between
constexpr Seconds kGlance{0.05};    // between two looks for a listener or a clock
constexpr double kFolderRate = 10;  // [Hz]

Clock::duration ticks(Seconds seconds) {
  return std::chrono::duration_cast<Clock::duration>(seconds);
}

}  // namespace

class CameraNodelet : public GuardedNodelet {
 public:
  ~CameraNodelet() override { finish(); }

 private:
  using Counts = CameraHealth::Counts;

  void start() override;
  void stop() override;
  void start_calibration();

  void work();
  void step();
  void open();
  void close(const std::string& reason);
  bool has_new_stamp() const;
  void play();
  cv::Mat retrieve();
  bool is_frozen(const cv::Mat& picture);
  void publish(const cv::Mat& picture, const ros::Time& stamp);
  void wait_until_due();
  void pause(Seconds time);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  CameraConfig config_;
  image_transport::CameraPublisher camera_;
  std::unique_ptr<camera_info_manager::CameraInfoManager> calibration_;
  CameraHealth health_;
  std::unique_ptr<HealthReport> report_;

  // Of the worker thread alone.
  std::unique_ptr<PictureSource> source_;
  FrozenPicture frozen_;
  Seconds retry_ = kFirstRetry;
  Clock::time_point due_;
  ros::Time last_stamp_;
  bool at_end_ = false;

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
    throw ConfigError(private_node().getNamespace() +
                      ": parameter 'source' is empty; give a device index or path, a stream URL, a "
                      "folder of pictures or a video file");
  start_calibration();
  image_transport::ImageTransport transport(node());
  camera_ = transport.advertiseCamera("image_raw", 5);
  report_ =
      std::make_unique<HealthReport>(node(), private_node(), getName(), config_.source,
                                     kPicturesTask, [this](auto& status) { diagnose(status); });
  worker_ = std::thread(&CameraNodelet::work, this);
}

void CameraNodelet::start_calibration() {
  const std::string where = private_node().getNamespace() + ": parameter '";
  calibration_ = std::make_unique<camera_info_manager::CameraInfoManager>(node());
  if (!calibration_->setCameraName(config_.camera_name))
    throw ConfigError(where + "camera_name': value '" + config_.camera_name +
                      "' is not allowed; give letters, digits and underscores");
  if (!calibration_->validateURL(config_.camera_info_url))
    throw ConfigError(where + "camera_info_url': value '" + config_.camera_info_url +
                      "' is not allowed; give file:///... or package://... or leave it empty");
  calibration_->loadCameraInfo(config_.camera_info_url);
  if (!calibration_->isCalibrated())
    NODELET_WARN("No calibration of camera '%s': poses will be in pixels only",
                 config_.camera_name.c_str());
}

void CameraNodelet::work() {
  for (;;) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (stopping_) return;
    }
    try {
      step();
    } catch (const std::exception& error) {
      close(error.what());
    }
  }
}

void CameraNodelet::step() {
  if (at_end_) return pause(kLongestRetry);
  if (!source_) open();
  // A folder or video waits for a listener and for the clock, so that none of its pictures is lost.
  if (!source_->is_live() && (camera_.getNumSubscribers() == 0 || !has_new_stamp()))
    return pause(kGlance);
  play();
}

void CameraNodelet::open() {
  std::vector<std::string> refused;
  source_ = open_picture_source(config_, refused);
  for (const auto& sentence : refused) NODELET_WARN("%s", sentence.c_str());
  NODELET_INFO("Opened %s", config_.source.c_str());
  health_.set_state(diagnostic_msgs::DiagnosticStatus::OK, "open");
  frozen_.reset();
  due_ = Clock::now();
}

void CameraNodelet::close(const std::string& reason) {
  source_.reset();
  health_.count(&Counts::failures);
  health_.set_state(diagnostic_msgs::DiagnosticStatus::ERROR, reason);
  NODELET_WARN("%s; trying again in %.1f s", reason.c_str(), retry_.count());
  pause(retry_);
  retry_ = std::min(2 * retry_, kLongestRetry);
}

bool CameraNodelet::has_new_stamp() const {
  const ros::Time now = ros::Time::now();
  return !now.isZero() && now != last_stamp_;
}

void CameraNodelet::play() {
  if (!source_->is_live()) wait_until_due();
  if (!source_->grab()) {
    at_end_ = true;
    health_.set_state(diagnostic_msgs::DiagnosticStatus::WARN, "at its end");
    NODELET_INFO("%s is at its end", config_.source.c_str());
    return;
  }
  const ros::Time stamp = ros::Time::now();
  retry_ = kFirstRetry;
  if (stamp.isZero() || stamp == last_stamp_) return health_.count(&Counts::unstamped);
  if (camera_.getNumSubscribers() == 0) return;
  const cv::Mat picture = retrieve();
  if (picture.empty() || is_frozen(picture)) return;
  last_stamp_ = stamp;
  publish(picture, stamp);
}

/// Empty, with a warning, when the picture cannot be read.
cv::Mat CameraNodelet::retrieve() {
  try {
    return source_->retrieve();
  } catch (const FileError& error) {
    health_.count(&Counts::unreadable);
    NODELET_WARN("%s", error.what());
    return {};
  }
}

bool CameraNodelet::is_frozen(const cv::Mat& picture) {
  if (!config_.detect_frozen) return false;
  if (!frozen_.update(picture)) {
    health_.set_state(diagnostic_msgs::DiagnosticStatus::OK, "open");
    return false;
  }
  health_.count(&Counts::frozen);
  const std::string sentence = config_.source + ": the picture is frozen; withheld";
  if (source_->is_live()) throw FileError(config_.source, "the picture is frozen");
  health_.set_state(diagnostic_msgs::DiagnosticStatus::ERROR, sentence);
  NODELET_WARN_THROTTLE(10, "%s", sentence.c_str());
  return true;
}

void CameraNodelet::publish(const cv::Mat& picture, const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = config_.frame_id;
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>(calibration_->getCameraInfo());
  info->header = header;
  if (!calibration_->isCalibrated()) {
    info->width = static_cast<std::uint32_t>(picture.cols);
    info->height = static_cast<std::uint32_t>(picture.rows);
  }
  camera_.publish(boost::make_shared<sensor_msgs::Image>(encode_picture(picture, header)), info);
  health_.count(&Counts::published);
}

void CameraNodelet::wait_until_due() {
  const double wanted = config_.frame_rate > 0 ? config_.frame_rate : source_->rate();
  const Clock::time_point now = Clock::now();
  if (due_ > now) pause(due_ - now);
  // A late picture does not make the next ones hurry.
  due_ = std::max(due_, now) + ticks(Seconds(1 / (wanted > 0 ? wanted : kFolderRate)));
}

void CameraNodelet::pause(Seconds time) {
  std::unique_lock<std::mutex> lock(mutex_);
  stopped_.wait_for(lock, time, [this] { return stopping_; });
}

void CameraNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  health_.describe(status);
  status.add("listeners", camera_.getNumSubscribers());
  status.add("calibrated", calibration_->isCalibrated() ? "yes" : "no");
}

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::CameraNodelet, nodelet::Nodelet)
