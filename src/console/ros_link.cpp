// SPDX-License-Identifier: BSD-3-Clause
#include "console/ros_link.hpp"

#include <dynamic_reconfigure/Reconfigure.h>
#include <mbncc_vision/FindObjects.h>
#include <mbncc_vision/LearnObjectActionGoal.h>
#include <mbncc_vision/LearnedObjectArray.h>
#include <mbncc_vision/ListObjects.h>
#include <sensor_msgs/SetCameraInfo.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "console/image/scaled_image.hpp"

namespace mbncc::console {
namespace {

const char* const kNoTeacher = "the learning nodelet does not answer";
const char* const kNoMatcher = "the matching nodelet does not answer";

// Limits for images that wait for their detections.
constexpr std::size_t kImagesKept = 30, kBytesKept = std::size_t{96} << 20;

constexpr float kHardlyAny = 0.02f;  // minimum score
const char* const kSearchRegion = "search_roi";
const char* const kSearchedImages = "searched_image";  // parameters of cell.launch
const char* const kCameraImages = "camera_image";

QSize size_of(const sensor_msgs::Image& message) {
  return {static_cast<int>(message.width), static_cast<int>(message.height)};
}

/// Text as in the parameter search_roi; "": the whole image.
std::string text_of(const QRect& region) {
  if (region.isEmpty()) return "";
  return std::to_string(region.x()) + "," + std::to_string(region.y()) + "," +
         std::to_string(region.width()) + "," + std::to_string(region.height());
}

QRect region_of(const dynamic_reconfigure::Config& config) {
  for (const auto& parameter : config.strs) {
    int x = 0, y = 0, width = 0, height = 0;
    if (parameter.name == kSearchRegion &&
        std::sscanf(parameter.value.c_str(), "%d,%d,%d,%d", &x, &y, &width, &height) == 4)
      return {x, y, width, height};
  }
  return {};
}

void announce_types() {
  qRegisterMetaType<actionlib_msgs::GoalStatusArray>("actionlib_msgs::GoalStatusArray");
  qRegisterMetaType<mbncc_vision::LearnObjectActionFeedback>(
      "mbncc_vision::LearnObjectActionFeedback");
  qRegisterMetaType<mbncc_vision::LearnObjectActionResult>("mbncc_vision::LearnObjectActionResult");
  qRegisterMetaType<mbncc_vision::LearnObjectResult>("mbncc_vision::LearnObjectResult");
  qRegisterMetaType<mbncc_vision::DetectedObjectArray>("mbncc_vision::DetectedObjectArray");
  qRegisterMetaType<diagnostic_msgs::DiagnosticArray>("diagnostic_msgs::DiagnosticArray");
  qRegisterMetaType<std::vector<mbncc_vision::LearnedObject>>(
      "std::vector<mbncc_vision::LearnedObject>");
  qRegisterMetaType<mbncc_vision::EditObject::Request>("mbncc_vision::EditObject::Request");
}

}  // namespace

RosLink::RosLink() {
  announce_types();
}

RosLink::~RosLink() {
  spinner_.stop();
  subscribers_.clear();
  images_.shutdown();
}

void RosLink::connect_to(const Names& names) {
  node_ = ros::NodeHandle(names.cell);
  matching_ = names.matching;
  node_.setCallbackQueue(&queue_);
  goal_publisher_ = node_.advertise<mbncc_vision::LearnObjectActionGoal>("learn_object/goal", 5);
  cancel_publisher_ = node_.advertise<actionlib_msgs::GoalID>("learn_object/cancel", 5);
  subscribe_lesson(node_);
  subscribe_cell(node_);
  subscribe_settings(node_);
  follow_images();
  spinner_.start();
}

void RosLink::subscribe_lesson(ros::NodeHandle& node) {
  const auto hear = [this](const auto& subscriber) { subscribers_.push_back(subscriber); };
  hear(node.subscribe<actionlib_msgs::GoalStatusArray>(
      "learn_object/status", 5,
      [this](const actionlib_msgs::GoalStatusArrayConstPtr& m) { Q_EMIT status_heard(*m); }));
  hear(node.subscribe<mbncc_vision::LearnObjectActionFeedback>(
      "learn_object/feedback", 50,
      [this](const mbncc_vision::LearnObjectActionFeedbackConstPtr& m) {
        Q_EMIT feedback_heard(*m);
      }));
  hear(node.subscribe<mbncc_vision::LearnObjectActionResult>(
      "learn_object/result", 5, [this](const mbncc_vision::LearnObjectActionResultConstPtr& m) {
        Q_EMIT result_heard(*m);
        list_objects();
      }));
  hear(node.subscribe<mbncc_vision::LearnObjectResult>(
      "learn_object/draft", 5,
      [this](const mbncc_vision::LearnObjectResultConstPtr& m) { Q_EMIT draft_heard(*m); }));
  hear(node.subscribe<sensor_msgs::Image>("learn_object/picture", 1,
                                          [this](const sensor_msgs::ImageConstPtr& m) {
                                            Q_EMIT lesson_image_heard(to_qimage(to_rgb(*m)));
                                          }));
  hear(node.subscribe<sensor_msgs::Image>("learn_object/score_map", 1,
                                          [this](const sensor_msgs::ImageConstPtr& m) {
                                            Q_EMIT score_map_heard(to_qimage(to_rgb(*m)));
                                          }));
}

void RosLink::subscribe_cell(ros::NodeHandle& node) {
  const auto hear = [this](const auto& subscriber) { subscribers_.push_back(subscriber); };
  hear(node.subscribe<mbncc_vision::DetectedObjectArray>(
      "detected_objects", 1,
      [this](const mbncc_vision::DetectedObjectArrayConstPtr& m) { take_detections(*m); }));
  hear(node.subscribe<mbncc_vision::LearnedObjectArray>(
      "object_library", 1,
      [this](const mbncc_vision::LearnedObjectArrayConstPtr&) { list_objects(); }));
  hear(node.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 20, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& m) {
        follow_images();
        Q_EMIT diagnostics_heard(*m);
      }));
}

std::string RosLink::image_topic(const std::string& parameter) const {
  const std::string topic = node_.resolveName("image_raw");
  const bool remapped = topic != node_.resolveName("image_raw", false);
  std::string named;
  if (remapped || !node_.getParamCached(parameter, named)) return topic;
  return node_.resolveName(named);
}

void RosLink::follow_images() {
  const std::string topic = image_topic(kSearchedImages);
  if (images_ && images_.getTopic() == topic) return;
  newest_.clear();
  images_ = node_.subscribe<sensor_msgs::Image>(
      topic, 1, [this](const sensor_msgs::ImageConstPtr& m) { take_image(m); });
}

void RosLink::subscribe_settings(ros::NodeHandle& node) {
  subscribers_.push_back(node.subscribe<dynamic_reconfigure::Config>(
      matching_ + "/parameter_updates", 5, [this](const dynamic_reconfigure::ConfigConstPtr& m) {
        Q_EMIT search_region_heard(region_of(*m));
      }));
}

void RosLink::take_detections(const mbncc_vision::DetectedObjectArray& detections) {
  Q_EMIT detections_heard(detections, (ros::Time::now() - detections.header.stamp).toSec());
  const auto searched =
      std::find_if(newest_.begin(), newest_.end(), [&](const sensor_msgs::ImageConstPtr& image) {
        return image->header.stamp == detections.header.stamp;
      });
  if (searched == newest_.end() || (*searched)->width != detections.image_width) return;
  const QImage image = to_qimage(small(live_rgb(**searched)));
  if (image.isNull()) return;
  note_shown(*searched);
  Q_EMIT searched_heard(image, size_of(**searched), detections);
}

cv::Mat RosLink::live_rgb(const sensor_msgs::Image& message) const {
  int white_level = 0;
  node_.getParamCached(matching_ + "/white_level", white_level);
  return to_rgb(message, white_level);
}

void RosLink::note_shown(const sensor_msgs::ImageConstPtr& message) {
  const std::lock_guard<std::mutex> lock(shown_mutex_);
  shown_ = message;
}

sensor_msgs::ImageConstPtr RosLink::shown() {
  const std::lock_guard<std::mutex> lock(shown_mutex_);
  return shown_;
}

void RosLink::take_image(const sensor_msgs::ImageConstPtr& message) {
  newest_.push_back(message);
  while (newest_.size() > 2 &&
         (newest_.size() > kImagesKept || newest_.size() * message->data.size() > kBytesKept))
    newest_.pop_front();
  cv::Mat image = small(live_rgb(*message));
  if (image.empty()) return;
  note_shown(message);
  origin_.take(message, ros::Time::now());
  Q_EMIT origin_heard(QString::fromStdString(origin_.warning()));
  if (changes_wanted_)
    image = tint_.tint(image);
  else
    tint_.reset();
  Q_EMIT image_heard(to_qimage(image), size_of(*message));
}

std::string RosLink::teach(const mbncc_vision::LearnObjectGoal& goal) {
  mbncc_vision::LearnObjectActionGoal message;
  message.header.stamp = message.goal_id.stamp = ros::Time::now();
  message.goal_id.id = ros::this_node::getName() + "-" + std::to_string(++goals_) + "-" +
                       std::to_string(message.header.stamp.toNSec());
  message.goal = goal;
  goal_publisher_.publish(message);
  return message.goal_id.id;
}

void RosLink::cancel(const std::string& goal) {
  actionlib_msgs::GoalID message;
  message.id = goal;
  cancel_publisher_.publish(message);
}

void RosLink::confirm(const mbncc_vision::ConfirmLearning::Request& request) {
  teaching_calls_.later([this, request] {
    mbncc_vision::ConfirmLearning call;
    call.request = request;
    const bool answered = teaching_calls_.call(node_, "confirm_learning", call);
    Q_EMIT confirmed(answered, call.response.success,
                     answered ? QString::fromStdString(call.response.message) : kNoTeacher);
  });
}

void RosLink::edit(const mbncc_vision::EditObject::Request& request) {
  teaching_calls_.later([this, request] {
    mbncc_vision::EditObject call;
    call.request = request;
    const bool answered = teaching_calls_.call(node_, "edit_object", call);
    Q_EMIT edited(request, answered && !call.response.retry, call.response.success,
                  answered ? QString::fromStdString(call.response.message) : kNoTeacher);
  });
  list_objects();
}

void RosLink::mark_grasp() {
  teaching_calls_.later([this] {
    std_srvs::Trigger call;
    const bool answered = teaching_calls_.call(node_, "mark_grasp", call);
    Q_EMIT grasp_marked(answered && call.response.success,
                        answered ? QString::fromStdString(call.response.message) : kNoTeacher);
  });
}

void RosLink::explain(QPointF place) {
  search_calls_.later([this, place, shown = shown()] {
    mbncc_vision::ExplainPlace call;
    call.request.place.x = place.x();
    call.request.place.y = place.y();
    if (shown) call.request.image = *shown;
    explained_ = call.request;
    const bool answered = search_calls_.call(node_, matching_ + "/explain", call);
    Q_EMIT explained(answered && call.response.success,
                     answered ? QString::fromStdString(call.response.message) : kNoMatcher,
                     answered ? to_qimage(to_rgb(call.response.picture)) : QImage());
  });
}

void RosLink::find_all() {
  search_calls_.later([this, shown = shown()] {
    if (!shown) return Q_EMIT all_found(false, "no image received yet", {}, {}, {});
    mbncc_vision::FindObjects call;
    call.request.image = *shown;
    call.request.min_score = kHardlyAny;
    const bool answered = search_calls_.call(node_, "find_objects", call);
    Q_EMIT all_found(answered && call.response.success,
                     answered ? QString::fromStdString(call.response.message) : kNoMatcher,
                     to_qimage(small(live_rgb(*shown))), size_of(*shown), call.response.detections);
  });
}

Thresholds RosLink::thresholds() const {
  Thresholds thresholds;
  node_.getParam(matching_ + "/min_score", thresholds.min_score);
  node_.getParam(matching_ + "/confirm_score", thresholds.confirm_score);
  return thresholds;
}

void RosLink::set_thresholds(const Thresholds& thresholds) {
  search_calls_.later([this, thresholds] {
    dynamic_reconfigure::Reconfigure call;
    const auto add = [&](const char* name, double value) {
      auto& parameter = call.request.config.doubles.emplace_back();
      parameter.name = name;
      parameter.value = value;
    };
    add("min_score", thresholds.min_score);
    add("confirm_score", thresholds.confirm_score);
    const bool answered = search_calls_.call(node_, matching_ + "/set_parameters", call);
    Q_EMIT thresholds_set(answered, answered ? "The matcher uses the new thresholds from now on; "
                                               "set them in config/matching.yaml to keep them."
                                             : kNoMatcher);
  });
}

void RosLink::set_search_region(const QRect& region) {
  search_calls_.later([this, region] {
    dynamic_reconfigure::Reconfigure call;
    auto& parameter = call.request.config.strs.emplace_back();
    parameter.name = kSearchRegion;
    parameter.value = text_of(region);
    const bool answered = search_calls_.call(node_, matching_ + "/set_parameters", call);
    if (!answered) return Q_EMIT search_region_set(false, kNoMatcher);
    const bool taken = region_of(call.response.config) == region;
    Q_EMIT search_region_set(taken, !taken             ? "the matcher refused the search region"
                                    : region.isEmpty() ? "The whole image is searched."
                                                       : "Only the region is searched.");
  });
}

void RosLink::keep_calibration(const sensor_msgs::CameraInfo& calibration) {
  if (image_topic(kSearchedImages) != image_topic(kCameraImages))
    return Q_EMIT calibration_kept(false,
                                   "these images are rectified, but the camera's raw images are "
                                   "needed; start the cell without rectify and top_view to "
                                   "calibrate the lens");
  camera_calls_.later([this, calibration] {
    sensor_msgs::SetCameraInfo call;
    call.request.camera_info = calibration;
    const bool answered = camera_calls_.call(node_, "set_camera_info", call);
    Q_EMIT calibration_kept(
        answered && call.response.success,
        answered
            ? QString::fromStdString(call.response.status_message)
            : "no camera in this cell accepts calibrations (set_camera_info); the simulated one "
              "has its own");
  });
}

CellImages RosLink::images() const {
  return {node_.getNamespace(), image_topic(kCameraImages),
          node_.param(matching_ + "/white_level", 0)};
}

void RosLink::save_explained() {
  search_calls_.later([this] {
    mbncc_vision::ExplainPlace call;
    call.request = explained_;
    call.request.save = true;
    const bool answered =
        search_calls_.call(node_, matching_ + "/explain", call) && call.response.success;
    Q_EMIT explained_saved(answered ? QString::fromStdString(call.response.file) : QString());
  });
}

std::string RosLink::why_no_grasps() const {
  std::string frame;
  if (node_.getParam(learning_ + "/gripper_frame", frame) && !frame.empty()) return "";
  return "Marking a grasp needs the gripper's frame: set gripper_frame of cell.launch";
}

void RosLink::list_objects() {
  teaching_calls_.later([this] {
    mbncc_vision::ListObjects call;
    call.request.with_thumbnails = true;
    if (teaching_calls_.call(node_, "list_objects", call))
      Q_EMIT objects_listed(call.response.objects,
                            QString::fromStdString(call.response.library_path),
                            call.response.library_inode);
  });
}

void RosLink::give_up_teaching() {
  teaching_calls_.give_up();
}

}  // namespace mbncc::console
