// SPDX-License-Identifier: BSD-3-Clause
// Teaches objects: the LearnObject action and the services of the library. Only connects the parts.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <unistd.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <string>

#include "mbncc/config/learning_node_config.hpp"
#include "mbncc/config/matching_node_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/health_tasks.hpp"
#include "mbncc/home_folder.hpp"
#include "mbncc/label.hpp"
#include "nodelets/common/camera_input.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"
#include "nodelets/common/interrupt_watch.hpp"
#include "nodelets/common/parameters.hpp"
#include "nodelets/conversion/platform_intrinsics.hpp"
#include "nodelets/learning/confirmation.hpp"
#include "nodelets/learning/image_feed.hpp"
#include "nodelets/learning/lesson_display.hpp"
#include "nodelets/learning/lesson_gauge.hpp"
#include "nodelets/learning/lesson_goal.hpp"
#include "nodelets/learning/lesson_server.hpp"
#include "nodelets/learning/lesson_session.hpp"
#include "nodelets/library/library_services.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {
namespace {

/// Namespace of the matching nodelet's parameters, below the private one. They are needed because a
/// lesson is evaluated with the search that will be used for its object.
constexpr char kSearchNamespace[] = "matching";

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

/// The configured name; if it is empty, host name and namespace, which distinguish the cells of a
/// network.
std::string cell_name(const std::string& configured, const std::string& name_space) {
  if (!is_valid_label(configured))
    throw ConfigError("parameter 'cell_name' must be printable UTF-8 of at most 200 bytes");
  if (!configured.empty()) return configured;
  return host_name() + (name_space == "/" ? "" : name_space);
}

}  // namespace

class LearningNodelet : public GuardedNodelet {
 public:
  ~LearningNodelet() override { finish(); }

 private:
  void start() override;
  void stop() override;
  void open_library(ros::NodeHandle& node);
  void tell_library(const std::string& folder, const LibrarySnapshot& snapshot);
  void start_images(ros::NodeHandle& node);
  void start_lessons(ros::NodeHandle& node);
  mbncc_vision::LearnObjectResult teach(LessonClient& client);
  bool mark_grasp(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool confirm(mbncc_vision::ConfirmLearning::Request& request,
               mbncc_vision::ConfirmLearning::Response& response);
  void refresh_library();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  LearningNodeConfig config_;
  SearchConfig search_;
  std::unique_ptr<LibraryPublisher> library_publisher_;
  std::shared_ptr<SharedLibrary> library_;
  std::unique_ptr<LibraryServices> library_services_;
  std::unique_ptr<ImageFeed> images_;
  std::unique_ptr<CameraInput> camera_;
  tf2_ros::Buffer tf_buffer_;
  std::unique_ptr<tf2_ros::TransformListener> tf_listener_;
  std::unique_ptr<LessonGauge> gauge_;
  std::unique_ptr<LessonDisplay> display_;
  Confirmation confirmation_;
  // confirm_learning waits for the lesson's answer, so it has its own callback thread.
  ros::CallbackQueue confirm_queue_;
  ros::AsyncSpinner confirm_spinner_{1, &confirm_queue_};
  ros::ServiceServer confirm_server_, mark_server_;
  std::unique_ptr<LessonServer> lessons_;
  std::unique_ptr<InterruptWatch> interrupt_watch_;
  std::unique_ptr<HealthReport> report_;
  ros::WallTimer library_timer_;
};

void LearningNodelet::start() {
  ros::NodeHandle own_node = node();
  read_parameters(private_node(), field_rows(config_), {kSearchNamespace});
  check_platform_intrinsics(config_.platform.platform_intrinsics);
  config_.cell_name = cell_name(config_.cell_name, own_node.getNamespace());
  MatchingNodeConfig matching;
  read_parameters(ros::NodeHandle(private_node(), kSearchNamespace), field_rows(matching));
  search_ = matching.search;
  open_library(own_node);
  start_images(own_node);
  start_lessons(own_node);
  report_ =
      std::make_unique<HealthReport>(own_node, private_node(), getName(), "none", kLearningTask,
                                     [this](auto& status) { diagnose(status); });
}

void LearningNodelet::stop() {
  library_timer_.stop();
  report_.reset();
  if (camera_) camera_->set_active(false);
  interrupt_watch_.reset();
  lessons_.reset();  // ends a running lesson, which releases a waiting confirm_learning
  confirm_spinner_.stop();
  confirm_server_.shutdown();
  library_services_.reset();
  library_publisher_.reset();
  display_.reset();
  camera_.reset();
  tf_listener_.reset();  // before its buffer
}

void LearningNodelet::open_library(ros::NodeHandle& node) {
  library_publisher_ = std::make_unique<LibraryPublisher>(node);
  const std::string folder = expand_home(config_.library_path);
  library_ = std::make_shared<SharedLibrary>(
      folder, [this, folder](const auto& snapshot) { tell_library(folder, *snapshot); });
  library_services_ = std::make_unique<LibraryServices>(node, library_);
  library_timer_ =
      node.createWallTimer(ros::WallDuration(1), [this](const auto&) { refresh_library(); });
}

void LearningNodelet::tell_library(const std::string& folder, const LibrarySnapshot& snapshot) {
  for (const auto& file : snapshot.quarantined)
    NODELET_WARN("%s %s: %s", file.file.c_str(),
                 file.moved ? "was moved to .quarantine" : "cannot be read", file.reason.c_str());
  library_publisher_->publish(folder, snapshot);
}

void LearningNodelet::refresh_library() {
  try {
    library_->refresh(false);
  } catch (const std::exception& error) {
    NODELET_ERROR_THROTTLE(10, "%s", error.what());
  }
}

void LearningNodelet::start_images(ros::NodeHandle& node) {
  tf_listener_ = std::make_unique<tf2_ros::TransformListener>(tf_buffer_);
  images_ = std::make_unique<ImageFeed>(config_.still_time, config_.images.white_level);
  camera_ = std::make_unique<CameraInput>(
      node, CameraInputConfig{config_.images.image_transport, config_.platform.max_info_age},
      [this](const sensor_msgs::ImageConstPtr& message) { images_->put(message); });
  gauge_ =
      std::make_unique<LessonGauge>(config_.platform, config_.gripper_frame, *camera_, tf_buffer_);
  // Always subscribed, because already_moved needs images from before the goal.
  camera_->set_active(true);
}

void LearningNodelet::start_lessons(ros::NodeHandle& node) {
  // The action's name may be remapped.
  display_ = std::make_unique<LessonDisplay>(node, node.resolveName("learn_object"));
  ros::NodeHandle confirm_node = node;
  confirm_node.setCallbackQueue(&confirm_queue_);
  confirm_server_ =
      confirm_node.advertiseService("confirm_learning", &LearningNodelet::confirm, this);
  confirm_spinner_.start();
  mark_server_ = node.advertiseService("mark_grasp", &LearningNodelet::mark_grasp, this);
  lessons_ = std::make_unique<LessonServer>(
      node, "learn_object", config_.learn_timeout,
      [this](const mbncc_vision::LearnObjectGoal& goal) {
        auto refused = check_goal(goal, *library_->snapshot(), config_.max_objects);
        return refused ? refused : check_storage(*library_);
      },
      [this](LessonClient& client) { return teach(client); });
  interrupt_watch_ = std::make_unique<InterruptWatch>([this] { lessons_->end(); });
}

mbncc_vision::LearnObjectResult LearningNodelet::teach(LessonClient& client) {
  const LessonTools tools{*images_,  *library_,        confirmation_, *gauge_,
                          *display_, config_.learning, search_,       config_.cell_name};
  const auto result = LessonSession(client, tools).run();
  const bool learned = result.error_code == mbncc_vision::LearnObjectResult::SUCCESS;
  if (learned) gauge_->clear();
  NODELET_INFO("%s %s", result.message.c_str(), learned ? "" : result.hint.c_str());
  return result;
}

bool LearningNodelet::mark_grasp(std_srvs::Trigger::Request&,
                                 std_srvs::Trigger::Response& response) {
  try {
    gauge_->mark(images_->state().header);
    response.success = true;
    response.message = lessons_->busy() ? "marked; stored with the running lesson"
                                        : "marked; stored with the next lesson, if that is "
                                          "taught from this demonstration (already_moved)";
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

bool LearningNodelet::confirm(mbncc_vision::ConfirmLearning::Request& request,
                              mbncc_vision::ConfirmLearning::Response& response) {
  response = confirmation_.ask(request);
  return true;
}

void LearningNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const ImageFeed::State state = images_->state();
  const auto library = library_->snapshot();
  const std::string fault = library_->fault().empty() ? camera_->fault() : library_->fault();
  if (!fault.empty())
    status.summary(DiagnosticStatus::ERROR, fault);
  else if (state.newest_refused)
    status.summary(DiagnosticStatus::ERROR, "no usable image: " + state.fault);
  else if (!state.any_image)
    status.summary(DiagnosticStatus::ERROR, "no image received yet");
  else
    status.summary(DiagnosticStatus::OK, lessons_->busy() ? "teaching" : "idle");
  status.add("scene", state.still ? "still" : "moving");
  status.add("images refused", state.refused);
  status.add("last fault", state.fault);
  status.add("library", library_->folder());
  status.add("objects", library->objects.size());
  status.add(kQuarantinedKey, library->quarantined.size());
}

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::LearningNodelet, nodelet::Nodelet)
