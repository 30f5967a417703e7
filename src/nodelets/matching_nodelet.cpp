// Finds learned objects in the camera's pictures. Wiring only.
#include <diagnostic_updater/diagnostic_updater.h>
#include <mbncc_vision/LearnedObjectArray.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <pluginlib/class_list_macros.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "mbncc/cell/stamp_gate.hpp"
#include "mbncc/config/matching_node_config.hpp"
#include "nodelets/camera_input.hpp"
#include "nodelets/detection_pipeline.hpp"
#include "nodelets/detection_publisher.hpp"
#include "nodelets/find_service.hpp"
#include "nodelets/images.hpp"
#include "nodelets/live_matcher.hpp"
#include "nodelets/mailbox.hpp"
#include "nodelets/parameters.hpp"
#include "nodelets/picture_wait.hpp"
#include "nodelets/search_roi.hpp"
#include "nodelets/search_statistics.hpp"
#include "nodelets/stale_watch.hpp"

namespace mbncc::nodelets {

class MatchingNodelet : public nodelet::Nodelet {
 public:
  ~MatchingNodelet() override { stop(); }

 private:
  void onInit() override;
  void start();
  void stop();
  void open_library();
  void start_search();
  void start_services();
  void start_watching();

  bool wanted() const;
  void listen_as_wanted();
  void on_image(const sensor_msgs::ImageConstPtr& image);
  void work();
  void search(const sensor_msgs::Image& image);
  bool admit(const std_msgs::Header& header);
  void refuse(const std::string& fault);

  bool enable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void look_for_changes();
  void look_for_silence();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  MatchingNodeConfig config_;
  SearchRequest request_;
  SharedStatistics statistics_;
  std::atomic<bool> enabled_{true};
  std::unique_ptr<LiveMatcher> matcher_;
  tf2_ros::Buffer tf_buffer_;
  std::unique_ptr<tf2_ros::TransformListener> tf_listener_;
  std::unique_ptr<DetectionPipeline> pipeline_;  // worker thread
  std::unique_ptr<StampGate> gate_;              // worker thread
  ros::Time last_searched_;                      // worker thread
  std::unique_ptr<DetectionPublisher> publisher_;
  std::unique_ptr<StaleWatch> silence_;
  PictureWait picture_wait_;
  Mailbox<sensor_msgs::ImageConstPtr> mailbox_;
  std::unique_ptr<CameraInput> camera_;
  std::thread worker_;
  // Calls that wait or read files have callback threads of their own.
  ros::CallbackQueue side_queue_;
  ros::AsyncSpinner side_spinner_{2, &side_queue_};
  std::unique_ptr<FindService> find_service_;
  ros::ServiceServer enable_server_;
  ros::Subscriber library_subscriber_;
  ros::WallTimer library_timer_, silence_timer_, diagnostics_timer_;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
};

void MatchingNodelet::onInit() {
  try {
    start();
  } catch (const std::exception& error) {
    NODELET_FATAL("%s", error.what());
    stop();
    throw;
  }
}

void MatchingNodelet::start() {
  read_parameters(getPrivateNodeHandle(), field_rows(config_));
  request_.roi = parse_roi(config_.search_roi);
  open_library();
  start_search();
  start_services();
  start_watching();
  side_spinner_.start();
  listen_as_wanted();
}

// Leaves nothing that uses the nodelet's callback queue: the loader takes that away before it
// deletes a nodelet which failed to start.
void MatchingNodelet::stop() {
  library_timer_.stop();
  silence_timer_.stop();
  diagnostics_timer_.stop();
  picture_wait_.close();
  side_spinner_.stop();
  find_service_.reset();
  enable_server_.shutdown();
  library_subscriber_.shutdown();
  if (camera_) camera_->set_active(false);
  mailbox_.close();
  if (worker_.joinable()) worker_.join();
  publisher_.reset();
  camera_.reset();
  diagnostics_.reset();
  tf_listener_.reset();  // before its buffer
}

void MatchingNodelet::open_library() {
  ros::NodeHandle node = getNodeHandle();
  node.setCallbackQueue(&side_queue_);
  matcher_ = std::make_unique<LiveMatcher>(config_.search, config_.library_path);
  // Who publishes a change tells of it sooner than the watch on the folder does.
  library_subscriber_ = node.subscribe<mbncc_vision::LearnedObjectArray>(
      "object_library", 1,
      [this](const mbncc_vision::LearnedObjectArrayConstPtr&) { look_for_changes(); });
  library_timer_ =
      node.createWallTimer(ros::WallDuration(1), [this](const auto&) { look_for_changes(); });
}

void MatchingNodelet::start_search() {
  ros::NodeHandle node = getNodeHandle();
  tf_listener_ = std::make_unique<tf2_ros::TransformListener>(tf_buffer_);
  pipeline_ = std::make_unique<DetectionPipeline>(config_, *matcher_, tf_buffer_);
  gate_ = std::make_unique<StampGate>(config_.max_age, config_.max_ahead);
  camera_ = std::make_unique<CameraInput>(
      node, config_.image_transport,
      [this](const sensor_msgs::ImageConstPtr& image) { on_image(image); });
  publisher_ = std::make_unique<DetectionPublisher>(node, getPrivateNodeHandle(),
                                                    [this] { listen_as_wanted(); });
  silence_ = std::make_unique<StaleWatch>(config_.stale_after);
  worker_ = std::thread([this] { work(); });
}

void MatchingNodelet::start_services() {
  ros::NodeHandle node = getNodeHandle();
  node.setCallbackQueue(&side_queue_);
  const FindTools tools{config_,  *matcher_,     tf_buffer_,
                        *camera_, picture_wait_, [this] { listen_as_wanted(); }};
  find_service_ = std::make_unique<FindService>(node, tools);
  enable_server_ =
      getPrivateNodeHandle().advertiseService("enable", &MatchingNodelet::enable, this);
}

void MatchingNodelet::start_watching() {
  ros::NodeHandle node = getNodeHandle();
  // Wall timers: a simulated clock may stand still, which is one way for pictures to stop.
  silence_timer_ =
      node.createWallTimer(ros::WallDuration(0.1), [this](const auto&) { look_for_silence(); });
  diagnostics_ =
      std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
  diagnostics_->setHardwareID("none");
  diagnostics_->add("matching", this, &MatchingNodelet::diagnose);
  diagnostics_timer_ = node.createWallTimer(ros::WallDuration(1),
                                            [this](const auto&) { diagnostics_->force_update(); });
}

bool MatchingNodelet::wanted() const {
  return enabled_ && (config_.publish_tf || publisher_->has_listeners());
}

void MatchingNodelet::listen_as_wanted() {
  if (publisher_ && camera_) camera_->set_active(wanted() || picture_wait_.wanted());
}

void MatchingNodelet::on_image(const sensor_msgs::ImageConstPtr& image) {
  picture_wait_.offer(image);
  if (!wanted()) return;
  const bool overtaken = mailbox_.put(image);
  statistics_.change([overtaken](SearchStatistics& statistics) {
    ++statistics.arrived;
    statistics.overtaken += overtaken ? 1 : 0;
  });
}

void MatchingNodelet::work() {
  while (const auto image = mailbox_.take()) {
    try {
      search(**image);
    } catch (const std::exception& error) {
      refuse(error.what());
    }
  }
}

void MatchingNodelet::search(const sensor_msgs::Image& image) {
  if (!admit(image.header)) return;
  const Decoded decoded = decode_picture(image);
  if (!decoded) return refuse(decoded.fault);
  const ReceivedPicture received{decoded.picture, image.header, camera_->camera_info_for(image)};
  const Detections detections = pipeline_->process(received, request_);
  const double latency = publisher_->publish(detections, decoded.picture, config_.publish_tf);
  silence_->restart();
  statistics_.change([&](SearchStatistics& statistics) {
    ++statistics.searched;
    statistics.search_time = detections.array.search_time;
    statistics.latency = latency;
    statistics.message = detections.array.message;
  });
}

bool MatchingNodelet::admit(const std_msgs::Header& header) {
  using Verdict = StampGate::Verdict;
  const Verdict verdict = gate_->judge(header.stamp.toSec(), ros::Time::now().toSec());
  if (verdict == Verdict::kRestarted) {
    NODELET_INFO("the clock has jumped back; starting anew");
    pipeline_->reset();
    publisher_->reset();
    last_searched_ = ros::Time();
  } else if (verdict != Verdict::kFresh) {
    statistics_.change([verdict](SearchStatistics& statistics) {
      ++statistics.badly_stamped;
      statistics.last_fault = std::string("stamp: ") + to_string(verdict);
    });
    return false;
  }
  if (config_.max_rate > 0 && (header.stamp - last_searched_).toSec() < 1 / config_.max_rate)
    return false;
  last_searched_ = header.stamp;
  return true;
}

void MatchingNodelet::refuse(const std::string& fault) {
  const bool news = statistics_.change([&fault](SearchStatistics& statistics) {
    ++statistics.refused;
    return std::exchange(statistics.last_fault, fault) != fault;
  });
  if (news) NODELET_WARN("picture refused: %s", fault.c_str());
}

bool MatchingNodelet::enable(std_srvs::SetBool::Request& request,
                             std_srvs::SetBool::Response& response) {
  enabled_ = request.data;
  listen_as_wanted();
  silence_->restart();
  response.success = true;
  response.message = request.data ? "searching" : "idle: disabled";
  return true;
}

void MatchingNodelet::look_for_changes() {
  try {
    matcher_->refresh(false);
  } catch (const std::exception& error) {
    NODELET_ERROR_THROTTLE(10, "%s", error.what());
  }
}

void MatchingNodelet::look_for_silence() {
  if (!wanted()) return silence_->restart();
  if (!silence_->due()) return;
  const std::string fault = statistics_.get().last_fault;
  publisher_->publish_stale(camera_->publishers() == 0 ? "nobody publishes pictures"
                            : fault.empty()            ? "pictures have stopped"
                                                       : "no usable picture; last " + fault);
}

void MatchingNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const SearchStatistics statistics = statistics_.get();
  const auto library = matcher_->library();
  if (!enabled_)
    status.summary(DiagnosticStatus::OK, "idle: disabled by ~enable");
  else if (!wanted())
    status.summary(DiagnosticStatus::OK, "idle: nobody listens and publish_tf is false");
  else if (camera_->publishers() == 0)
    status.summary(DiagnosticStatus::WARN, "nobody publishes pictures");
  else if (!statistics.message.empty())
    status.summary(DiagnosticStatus::WARN, statistics.message);
  else
    status.summary(DiagnosticStatus::OK, "searching");
  status.add("pictures arrived", statistics.arrived);
  status.add("pictures searched", statistics.searched);
  status.add("pictures overtaken by newer ones", statistics.overtaken);
  status.add("pictures refused", statistics.refused);
  status.add("pictures badly stamped", statistics.badly_stamped);
  status.add("last fault", statistics.last_fault);
  status.add("search time [s]", statistics.search_time);
  status.add("latency [s]", statistics.latency);
  status.add("library", matcher_->folder());
  status.add("objects", library->objects.size());
  status.add("files quarantined", library->quarantined.size());
}

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::MatchingNodelet, nodelet::Nodelet)
