// SPDX-License-Identifier: BSD-3-Clause
// Finds learned objects in the camera's images. Only connects the parts.
#include <mbncc_vision/LearnedObjectArray.h>
#include <mbncc_vision/ListObjects.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/RegionOfInterest.h>
#include <std_srvs/SetBool.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <pluginlib/class_list_macros.hpp>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mbncc/config/matching_node_config.hpp"
#include "mbncc/health_tasks.hpp"
#include "nodelets/common/camera_input.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"
#include "nodelets/common/parameters.hpp"
#include "nodelets/common/reconfigure.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/conversion/platform_intrinsics.hpp"
#include "nodelets/matching/detection_publisher.hpp"
#include "nodelets/matching/explain_service.hpp"
#include "nodelets/matching/find_service.hpp"
#include "nodelets/matching/image_wait.hpp"
#include "nodelets/matching/live_matcher.hpp"
#include "nodelets/matching/live_settings.hpp"
#include "nodelets/matching/search_roi.hpp"
#include "nodelets/matching/search_worker.hpp"

namespace mbncc::nodelets {
namespace {

/// Settings that may change at run time.
const std::vector<std::string> kLiveParameters{
    "min_score",     "confirm_score",  "min_margin_place", "min_margin_angle",
    "max_instances", "confirm_frames", "confirm_window",   "hold_time",
    "search_roi",    "max_rate",       "publish_tf",       "show_score_map"};

/// Throws with a message if parameters that are individually valid contradict each other.
void check(const MatchingNodeConfig& config) {
  parse_roi(config.search_roi);
  check_platform_intrinsics(config.platform.platform_intrinsics);
  InstanceTracker{tracker_config(config)};
}

}  // namespace

class MatchingNodelet : public GuardedNodelet {
 public:
  ~MatchingNodelet() override { finish(); }

 private:
  void start() override;
  void stop() override;
  void open_library();
  void start_search();
  void start_services();
  void start_watching();

  bool wanted() const;
  void listen_as_wanted();
  void on_image(const sensor_msgs::ImageConstPtr& image);

  bool enable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void change_settings(const std::function<void(const Rows&)>& use);
  void apply_settings();
  void on_roi(const sensor_msgs::RegionOfInterest& roi);
  bool list(mbncc_vision::ListObjects::Request& request,
            mbncc_vision::ListObjects::Response& response);
  void refresh_library();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  std::unique_ptr<LiveSettings> settings_;
  std::atomic<bool> enabled_{true};
  std::unique_ptr<LiveMatcher> matcher_;
  tf2_ros::Buffer tf_buffer_;
  std::unique_ptr<tf2_ros::TransformListener> tf_listener_;
  std::unique_ptr<DetectionPublisher> publisher_;
  ImageWait image_wait_;
  std::unique_ptr<CameraInput> camera_;
  std::unique_ptr<DetectionPipeline> pipeline_;
  std::unique_ptr<SearchWorker> worker_;
  // Callbacks that read files have their own thread.
  ros::CallbackQueue side_queue_;
  ros::AsyncSpinner side_spinner_{1, &side_queue_};
  std::unique_ptr<FindService> find_service_;
  std::unique_ptr<ExplainService> explain_service_;
  std::unique_ptr<Reconfigure> reconfigure_;
  ros::ServiceServer enable_server_, list_server_;
  ros::Subscriber library_subscriber_, roi_subscriber_;
  ros::WallTimer library_timer_, silence_timer_;
  std::unique_ptr<HealthReport> report_;
};

void MatchingNodelet::start() {
  MatchingNodeConfig config;
  read_parameters(private_node(), field_rows(config));
  check(config);
  settings_ = std::make_unique<LiveSettings>(config);
  open_library();
  start_search();
  start_services();
  start_watching();
  side_spinner_.start();
  listen_as_wanted();
}

void MatchingNodelet::stop() {
  library_timer_.stop();
  silence_timer_.stop();
  report_.reset();
  image_wait_.close();
  side_spinner_.stop();
  find_service_.reset();
  roi_subscriber_.shutdown();
  explain_service_.reset();
  reconfigure_.reset();
  enable_server_.shutdown();
  list_server_.shutdown();
  library_subscriber_.shutdown();
  if (camera_) camera_->set_active(false);
  worker_.reset();
  publisher_.reset();
  camera_.reset();
  tf_listener_.reset();  // before its buffer
}

void MatchingNodelet::open_library() {
  ros::NodeHandle side_node = node();
  side_node.setCallbackQueue(&side_queue_);
  matcher_ =
      std::make_unique<LiveMatcher>(settings_->initial().search, settings_->initial().library_path);
  // The topic reports a change sooner than the periodic check of the folder.
  library_subscriber_ = side_node.subscribe<mbncc_vision::LearnedObjectArray>(
      "object_library", 1,
      [this](const mbncc_vision::LearnedObjectArrayConstPtr&) { refresh_library(); });
  library_timer_ =
      side_node.createWallTimer(ros::WallDuration(1), [this](const auto&) { refresh_library(); });
}

void MatchingNodelet::start_search() {
  tf_listener_ = std::make_unique<tf2_ros::TransformListener>(tf_buffer_);
  const MatchingNodeConfig& config = settings_->initial();
  camera_ = std::make_unique<CameraInput>(
      node(),
      CameraInputConfig{config.images.image_transport, config.platform.max_info_age,
                        config.queue_size},
      [this](const sensor_msgs::ImageConstPtr& image) { on_image(image); });
  publisher_ =
      std::make_unique<DetectionPublisher>(node(), private_node(), [this] { listen_as_wanted(); });
  pipeline_ = std::make_unique<DetectionPipeline>(config, *matcher_, tf_buffer_);
  worker_ = std::make_unique<SearchWorker>(
      SearchTools{*settings_, *matcher_, *pipeline_, *camera_, *publisher_});
}

void MatchingNodelet::start_services() {
  ros::NodeHandle side_private_node = private_node();
  side_private_node.setCallbackQueue(&side_queue_);
  const FindTools tools{*settings_, *matcher_,   tf_buffer_,
                        *camera_,   image_wait_, [this] { listen_as_wanted(); }};
  find_service_ = std::make_unique<FindService>(node(), tools);
  explain_service_ = std::make_unique<ExplainService>(
      private_node(), ExplainTools{[this] { return settings_->get(); }, *matcher_, image_wait_,
                                   [this] { listen_as_wanted(); }});
  enable_server_ = private_node().advertiseService("enable", &MatchingNodelet::enable, this);
  reconfigure_ = std::make_unique<Reconfigure>(
      side_private_node, [this](const auto& use) { change_settings(use); },
      [this] { apply_settings(); });
  list_server_ = side_private_node.advertiseService("list_objects", &MatchingNodelet::list, this);
  roi_subscriber_ = side_private_node.subscribe("search_roi", 1, &MatchingNodelet::on_roi, this);
}

void MatchingNodelet::start_watching() {
  // A wall timer, because a simulated clock may stop, and then images stop as well.
  silence_timer_ = node().createWallTimer(ros::WallDuration(0.1),
                                          [this](const auto&) { worker_->check_stale(wanted()); });
  report_ = std::make_unique<HealthReport>(node(), private_node(), getName(), "none", kMatchingTask,
                                           [this](auto& status) { diagnose(status); });
}

bool MatchingNodelet::wanted() const {
  return enabled_ && (settings_->get().publish_tf || publisher_->has_listeners());
}

void MatchingNodelet::listen_as_wanted() {
  if (publisher_ && camera_)
    camera_->set_active([this] { return wanted() || image_wait_.wanted(); });
}

void MatchingNodelet::on_image(const sensor_msgs::ImageConstPtr& image) {
  image_wait_.offer(image);
  if (wanted()) worker_->put(image);
}

void MatchingNodelet::change_settings(const std::function<void(const Rows&)>& use) {
  settings_->change([&](MatchingNodeConfig& config) {
    const MatchingNodeConfig before = config;
    use(chosen(field_rows(config), kLiveParameters));
    try {
      check(config);
    } catch (const std::exception& error) {
      NODELET_WARN("%s", error.what());
      config = before;
    }
  });
}

void MatchingNodelet::apply_settings() {
  // Earlier detections were evaluated with other thresholds.
  if (matcher_->configure(settings_->get().search)) worker_->invalidate_detections();
  listen_as_wanted();
}

void MatchingNodelet::on_roi(const sensor_msgs::RegionOfInterest& roi) {
  const std::string text = roi.width == 0 && roi.height == 0
                               ? ""
                               : std::to_string(roi.x_offset) + "," + std::to_string(roi.y_offset) +
                                     "," + std::to_string(roi.width) + "," +
                                     std::to_string(roi.height);
  reconfigure_->set("search_roi", text);
}

bool MatchingNodelet::list(mbncc_vision::ListObjects::Request& request,
                           mbncc_vision::ListObjects::Response& response) {
  response.library_path = matcher_->folder();
  response.library_inode = folder_inode(response.library_path);
  for (const auto& object : matcher_->library()->objects)
    response.objects.push_back(to_msg(*object, request.with_thumbnails));
  return true;
}

bool MatchingNodelet::enable(std_srvs::SetBool::Request& request,
                             std_srvs::SetBool::Response& response) {
  if (enabled_.exchange(request.data) != static_cast<bool>(request.data))
    worker_->invalidate_detections();
  listen_as_wanted();
  response.success = true;
  response.message = request.data ? "searching" : "idle: disabled";
  return true;
}

void MatchingNodelet::refresh_library() {
  try {
    matcher_->refresh(false);
  } catch (const std::exception& error) {
    NODELET_ERROR_THROTTLE(10, "%s", error.what());
  }
}

void MatchingNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const SearchStatistics statistics = worker_->statistics();
  const auto library = matcher_->library();
  const std::string idle = !enabled_   ? "disabled by ~enable"
                           : !wanted() ? "no subscriber and publish_tf is false"
                                       : "";
  const std::string fault = matcher_->fault();
  summarize(status, fault.empty() && idle.empty() ? camera_->fault() : fault, idle, statistics);
  add_to(status, statistics);
  status.add("library", matcher_->folder());
  status.add("objects", library->objects.size());
  const PlatformConfig& platform = settings_->initial().platform;
  if (!platform.platform_frame.empty())
    status.add("platform calibrated with", platform.platform_intrinsics.empty()
                                               ? "unknown: a new calibration of the camera would "
                                                 "not be noticed; run calibrate_platform again"
                                               : platform.platform_intrinsics);
  status.add(kQuarantinedKey, library->quarantined.size());
}

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::MatchingNodelet, nodelet::Nodelet)
