// SPDX-License-Identifier: BSD-3-Clause
// Publishes detections as vision_msgs while there is a subscriber.
#include <ros/ros.h>
#include <vision_msgs/VisionInfo.h>
#include <pluginlib/class_list_macros.hpp>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "mbncc/health_tasks.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"
#include "nodelets/common/parameters.hpp"
#include "nodelets/vision/vision_messages.hpp"

namespace mbncc::nodelets {

class VisionNodelet : public GuardedNodelet {
 public:
  ~VisionNodelet() override { finish(); }

 private:
  void start() override {
    ros::NodeHandle handle = private_node();
    const ros::SubscriberStatusCallback changed = [this](const auto&) { listen_as_wanted(); };
    // The first subscriber may connect before the publishers are stored.
    const std::lock_guard<std::mutex> lock(mutex_);
    detections_2d_ =
        handle.advertise<vision_msgs::Detection2DArray>("detections", 10, changed, changed);
    detections_3d_ =
        handle.advertise<vision_msgs::Detection3DArray>("detections_3d", 10, changed, changed);
    info_ = handle.advertise<vision_msgs::VisionInfo>("vision_info", 1, true);
    publish_names();
    report_ = std::make_unique<HealthReport>(node(), private_node(), getName(), "none", kVisionTask,
                                             [this](auto& status) { diagnose(status); });
  }

  void stop() override {
    report_.reset();
    const std::lock_guard<std::mutex> lock(mutex_);
    subscriber_.shutdown();
  }

  void listen_as_wanted() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool wanted =
        detections_2d_.getNumSubscribers() > 0 || detections_3d_.getNumSubscribers() > 0;
    if (wanted && !subscriber_)
      subscriber_ = node().subscribe("detected_objects", 10, &VisionNodelet::on_detections, this);
    else if (!wanted)
      subscriber_.shutdown();
  }

  void on_detections(const mbncc_vision::DetectedObjectArrayConstPtr& detections) {
    // Published first, so that subscribers can look up the name of every number that they receive.
    if (ids_.add(*detections)) publish_names();
    for (const auto& object : detections->objects)
      if (!ids_.has(object.name))
        NODELET_ERROR_THROTTLE(10, "'%s' has the same number as '%s' and is left out; rename one",
                               object.name.c_str(),
                               ids_.names().at(object_id(object.name)).c_str());
    detections_2d_.publish(to_detections_2d(*detections, ids_));
    detections_3d_.publish(to_detections_3d(*detections, ids_));
    ++published_;
  }

  /// Reports only on publishing; whether detections are reliable is reported by the matching
  /// nodelet.
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    status.summary(diagnostic_msgs::DiagnosticStatus::OK,
                   subscriber_ ? "publishing" : "idle: no subscriber");
    status.add("published", published_);
    status.add("objects named", ids_.names().size());
  }

  void publish_names() {
    vision_msgs::VisionInfo info;
    info.header.stamp = ros::Time::now();
    info.method = "map-based normalized cross correlation";
    info.database_location = private_node().resolveName("object_ids");
    info.database_version = version_++;
    XmlRpc::XmlRpcValue ids;
    ids.begin();  // makes an empty struct if there are no names yet
    for (const auto& [id, name] : ids_.names()) ids[name] = static_cast<int>(id);
    store_parameter(private_node().resolveName("object_ids"), ids);
    info_.publish(info);
  }

  std::mutex mutex_;  // guards the subscriber
  ros::Subscriber subscriber_;
  ros::Publisher detections_2d_, detections_3d_, info_;
  ObjectIds ids_;
  int version_ = 0;
  std::uint64_t published_ = 0;
  std::unique_ptr<HealthReport> report_;
};

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::VisionNodelet, nodelet::Nodelet)
