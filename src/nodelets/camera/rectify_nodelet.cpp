// SPDX-License-Identifier: BSD-3-Clause
// Publishes rectified images of a camera while there is a subscriber: image_rect or, with the
// parameter top_view, top_view/image_rect and top_view/camera_info.
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "mbncc/config/rectify_config.hpp"
#include "mbncc/error.hpp"
#include "nodelets/camera/rectified_view.hpp"
#include "nodelets/camera/rectifier.hpp"
#include "nodelets/common/camera_input.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"
#include "nodelets/common/mailbox.hpp"
#include "nodelets/common/parameters.hpp"
#include "nodelets/conversion/images.hpp"

namespace mbncc::nodelets {

class RectifyNodelet : public GuardedNodelet {
 public:
  ~RectifyNodelet() override { finish(); }

 private:
  void start() override {
    read_parameters(private_node(), field_rows(config_));
    if (config_.rectified && !config_.top_view)
      throw ConfigError(
          "the images are rectified already: start the cell with rectify:=false, or with "
          "rectified:=false if they are not");
    camera_ = std::make_unique<CameraInput>(
        node(), CameraInputConfig{config_.images.image_transport, config_.max_info_age},
        [this](const sensor_msgs::ImageConstPtr& message) { mailbox_.put(message); });
    if (config_.top_view) {
      top_view_ = std::make_unique<TopView>(config_);
      infos_ = node().advertise<sensor_msgs::CameraInfo>("top_view/camera_info", 1);
    }
    worker_ = std::thread([this] { work(); });
    image_transport::ImageTransport transport(node());
    const image_transport::SubscriberStatusCallback changed = [this](const auto&) {
      listen_as_wanted();
    };
    {
      // The first subscriber may connect before the publisher is stored.
      const std::lock_guard<std::mutex> lock(mutex_);
      publisher_ = transport.advertise(top_view_ ? "top_view/image_rect" : "image_rect", 1, changed,
                                       changed);
    }
    report_ =
        std::make_unique<HealthReport>(node(), private_node(), getName(), "none", "rectifying",
                                       [this](auto& status) { diagnose(status); });
  }

  void stop() override {
    report_.reset();
    if (camera_) camera_->set_active(false);
    mailbox_.close();
    if (worker_.joinable()) worker_.join();  // it uses the publisher
    image_transport::Publisher closing;
    {
      // A subscriber may connect or disconnect at the same time.
      const std::lock_guard<std::mutex> lock(mutex_);
      std::swap(closing, publisher_);
    }
    closing.shutdown();
    camera_.reset();
  }

  void listen_as_wanted() {
    const std::lock_guard<std::mutex> lock(mutex_);
    camera_->set_active(publisher_.getNumSubscribers() > 0);
  }

  void work() {
    while (const auto message = mailbox_.take()) {
      try {
        note(publish(**message));
      } catch (const std::exception& error) {
        note(error.what());
      }
    }
  }

  /// Rectifies and publishes an image. Returns why it was not published; "" if it was.
  std::string publish(const sensor_msgs::Image& message) {
    const Decoded decoded = decode_image(message, config_.images.white_level);
    if (!decoded) return decoded.fault;
    const auto info = camera_->camera_info_for(message.header, decoded.image.size());
    if (!info) return kNoCameraInfo;
    const cv::Size size = decoded.image.size();
    const RectifiedView view = top_view_ ? top_view_->view(*info, message.header, size)
                                         : without_distortion(*info, message.header, size);
    if (!view) return view.fault;
    std_msgs::Header header = message.header;
    header.frame_id = view.frame_id;
    if (top_view_) publish_info(view, header, size);
    const cv::Mat rectified = rectifier_.rectify(decoded.image, view.lens, view.wanted);
    publisher_.publish(boost::make_shared<sensor_msgs::Image>(encode_image(rectified, header)));
    return "";
  }

  void publish_info(const RectifiedView& view, const std_msgs::Header& header, cv::Size size) {
    const auto info =
        boost::make_shared<sensor_msgs::CameraInfo>(camera_info_of(view.wanted.camera, size));
    info->header = header;
    infos_.publish(info);
  }

  void note(const std::string& fault) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!fault.empty() && fault != fault_) NODELET_WARN("image not rectified: %s", fault.c_str());
    fault_ = fault;
    ++(fault.empty() ? published_ : refused_);
  }

  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    using diagnostic_msgs::DiagnosticStatus;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (publisher_.getNumSubscribers() == 0)
      status.summary(DiagnosticStatus::OK, "idle: no subscriber");
    else if (const auto fault = camera_->fault(); !fault.empty())
      status.summary(DiagnosticStatus::ERROR, fault);
    else if (!fault_.empty())
      status.summary(DiagnosticStatus::ERROR, fault_);
    else
      status.summary(DiagnosticStatus::OK, "rectifying");
    status.add("published", published_);
    status.add("refused", refused_);
  }

  RectifyConfig config_;
  std::unique_ptr<CameraInput> camera_;
  Mailbox<sensor_msgs::ImageConstPtr> mailbox_;
  std::unique_ptr<TopView> top_view_;  // used by the worker thread only; null: not wanted
  Rectifier rectifier_;                // used by the worker thread only
  ros::Publisher infos_;
  std::mutex mutex_;  // guards publisher_, fault_ and the counts
  image_transport::Publisher publisher_;
  std::string fault_;
  std::uint64_t published_ = 0, refused_ = 0;
  std::unique_ptr<HealthReport> report_;
  std::thread worker_;
};

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::RectifyNodelet, nodelet::Nodelet)
