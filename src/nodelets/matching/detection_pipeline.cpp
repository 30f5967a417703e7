// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/detection_pipeline.hpp"

#include <tf2_eigen/tf2_eigen.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string>

#include "mbncc/cell/image_distortion.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/conversion/pose_algebra.hpp"
#include "nodelets/conversion/tf_wait.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

constexpr double kNotableYawError = 0.25;  // [degrees] smallest yaw error that is reported

bool any_enabled(const LibrarySnapshot& library) {
  return std::any_of(library.objects.begin(), library.objects.end(),
                     [](const auto& object) { return object->enabled; });
}

/// Message about tilt and distortion if they make yaw less certain than the search usually does;
/// otherwise "".
std::string advice_on_distortion(const Calibration& calibration) {
  const double yaw = to_degrees(yaw_error_of(calibration.distortion));
  if (yaw < kNotableYawError) return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "yaw is uncertain by " << yaw
       << " degrees, because the image shows the platform tilted (by "
       << to_degrees(calibration.tilt)
       << " degrees) or distorted; start the cell with top_view:=true, which needs the platform's "
          "frame, or with rectify:=true to remove only the distortion";
  return text.str();
}

/// Removes frames that would have the name of another object's frame: object_part_2 belongs to
/// instance 2 of 'part' or to an object 'part_2'. Returns a message about one; "" if there is none.
std::string remove_shared_frames(DetectedObjectArray& array, const LibrarySnapshot& library) {
  std::string fault;
  const auto is_known = [&](const std::string& name, const DetectedObject& object) {
    if (!library.find(name)) return false;
    fault = "frames of '" + object.name + "' are not sent, because they would have the names of " +
            "those of '" + name + "'; rename one of the two";
    return true;
  };
  for (auto& object : array.objects) {
    if (object.child_frame_id.empty()) continue;
    const std::string numbered =
        object.name + object.child_frame_id.substr(object.child_frame_id.rfind('_'));
    const bool shared = is_known(numbered, object);
    const bool grasp_shared = object.has_grasp && (is_known(object.name + "_grasp", object) ||
                                                   is_known(numbered + "_grasp", object));
    if (shared || grasp_shared) object.child_frame_id.clear();
    if (grasp_shared) object.stable_frame_id.clear();
  }
  return fault;
}

/// Sets the status that is most important for a controller: a pose that is not in metres or is in a
/// wrong frame would move an arm wrongly, whereas objects that were not searched are only missed.
void set_status(DetectedObjectArray& array, const LibrarySnapshot& library,
                const Calibration& calibration, const SearchResult& result,
                const std::string& target_fault, const std::string& frame_fault) {
  if (!any_enabled(library)) {
    array.status = DetectedObjectArray::LIBRARY_EMPTY;
    array.message = "no enabled object in the library; teach one";
  } else if (!calibration.platform) {
    array.status = DetectedObjectArray::UNCALIBRATED;
    array.message = calibration.fault;
  } else if (!target_fault.empty()) {
    array.status = DetectedObjectArray::TF_UNAVAILABLE;
    array.message = target_fault;
  } else if (result.budget_exceeded) {
    array.status = DetectedObjectArray::BUDGET_EXCEEDED;
    array.message = "time_budget exceeded; some objects were not searched";
  } else {
    array.status = DetectedObjectArray::OK;
    array.message = !result.limited.empty()
                        ? "max_instances reached by " + result.limited.front() +
                              "; there may be more instances, raise max_instances"
                    : !frame_fault.empty() ? frame_fault
                                           : advice_on_distortion(calibration);
  }
}

void transform_poses(DetectedObject& object, const geometry_msgs::TransformStamped& transform) {
  geometry_msgs::PoseWithCovarianceStamped pose;
  geometry_msgs::PoseStamped grasp;
  pose.pose = object.pose;
  grasp.pose = object.grasp;
  tf2::doTransform(pose, pose, transform);
  if (object.has_grasp) tf2::doTransform(grasp, grasp, transform);
  object.pose = pose.pose;
  object.grasp = grasp.pose;
}

/// Transforms the poses from the camera's frame as it was `then` to that of `now`, which differs if
/// the camera is on the robot.
void follow_camera(DetectedObject& object, const Calibration& then, const Calibration& now) {
  if (then.T_camera_platform && now.T_camera_platform)
    transform_poses(
        object, tf2::eigenToTransform(*now.T_camera_platform * then.T_camera_platform->inverse()));
}

/// Rotates the object's frame by half a turn about its x axis.
void flip_z_axis(DetectedObject& object) {
  object.pose.pose = compose(object.pose.pose, half_turn_about_x());
  for (auto& corner : object.footprint.points) {
    corner.y = -corner.y;
    corner.z = -corner.z;
  }
}

}  // namespace

TrackerConfig tracker_config(const MatchingNodeConfig& config) {
  TrackerConfig tracker;
  tracker.confirm_frames = config.confirm_frames;
  tracker.confirm_window = config.confirm_window;
  tracker.hold_time = config.hold_time;
  tracker.max_age = config.max_age;
  return tracker;
}

DetectionPipeline::DetectionPipeline(const MatchingNodeConfig& config, const LiveMatcher& matcher,
                                     const tf2_ros::Buffer& tf)
    : config_(config),
      matcher_(matcher),
      tf_(tf),
      video_(config.video),
      tracker_(tracker_config(config)),
      average_(config.average_frames) {}

void DetectionPipeline::configure(const MatchingNodeConfig& config) {
  tracker_.configure(tracker_config(config));
  config_ = config;
}

Detections DetectionPipeline::process(const ReceivedImage& received, const SearchRequest& request) {
  return describe(received, track(received, request));
}

void DetectionPipeline::interrupt() {
  video_.reset();
  tracker_.interrupt();
  average_.reset();
}

void DetectionPipeline::reset() {
  interrupt();
  tracker_.reset();
}

TrackedImage DetectionPipeline::track(const ReceivedImage& received, const SearchRequest& request) {
  const double stamp = received.header.stamp.toSec();
  TrackedImage tracked{config_.video.sweep_time > 0
                           ? matcher_.watch(video_, stamp, received.image, request)
                           : matcher_.find(received.image, request),
                       {}};
  tracked.matches = tracker_.update(stamp, tracked.found.result.matches);
  average_.apply(tracked.matches);
  return tracked;
}

Detections DetectionPipeline::describe(const ReceivedImage& received,
                                       const TrackedImage& tracked) const {
  const SearchResult& result = tracked.found.result;
  wait_for_tf(received.header);
  const Calibration calibration = calibrate(config_.platform, received.camera_info.get(),
                                            received.header, received.image.size(), tf_);
  Detections detections{{}, tracked.found.library};
  DetectedObjectArray& array = detections.array;
  array.header = received.header;
  array.header.frame_id = camera_frame_of(config_.platform, received.header);
  array.image_width = static_cast<std::uint32_t>(received.image.cols);
  array.image_height = static_cast<std::uint32_t>(received.image.rows);
  array.searched = result.searched;
  array.skipped = result.skipped;
  array.search_time = static_cast<float>(result.search_time);
  for (const auto& match : tracked.matches) {
    auto model = detections.library->find(match.match.name);
    // A held instance may be of an earlier lesson, with another frame, height and grasp.
    if (model && model->revision != match.match.revision) model = nullptr;
    array.objects.push_back(match.state == TrackState::kHeld
                                ? describe_held(match, model.get(), received, calibration)
                                : describe(match, model.get(), calibration));
  }
  const std::string frame_fault = remove_shared_frames(array, *detections.library);
  const std::string target_fault = to_target_frame(array);
  set_status(array, *detections.library, calibration, result, target_fault, frame_fault);
  return detections;
}

DetectedObject DetectionPipeline::describe_held(const TrackedMatch& tracked,
                                                const ObjectModel* model,
                                                const ReceivedImage& received,
                                                const Calibration& now) const {
  std_msgs::Header header = received.header;
  header.stamp.fromSec(tracked.seen_at);
  const Calibration then =
      calibrate(config_.platform, received.camera_info.get(), header, received.image.size(), tf_);
  DetectedObject object = describe(tracked, model, now.platform ? then : now);
  if (object.pose_valid) follow_camera(object, then, now);
  return object;
}

DetectedObject DetectionPipeline::describe(const TrackedMatch& tracked, const ObjectModel* model,
                                           const Calibration& calibration) const {
  const Match& match = tracked.match;
  DetectedObject object = to_msg(match, model);
  object.instance_id = tracked.instance_id;
  object.state = static_cast<std::uint8_t>(tracked.state);
  object.reasons = tracked.reasons;
  object.valid_until.fromSec(tracked.valid_until);
  if (!calibration.platform || model == nullptr) return object;
  const cv::Matx33d covariance =
      with_distortion(match.covariance, calibration.distortion, match.outline);
  const auto pose = calibration.platform->lift(match.pose, covariance, model->object_height);
  if (!pose) return object;
  object.pose_valid = true;
  object.pose = to_msg(*pose);
  object.footprint = footprint_of(*model);
  object.has_grasp = model->grasp.has_value();
  if (model->grasp) object.grasp = compose(object.pose.pose, to_msg(*model->grasp));
  if (config_.object_frame_z == "out") flip_z_axis(object);
  const std::string frame = config_.tf_prefix + "object_" + match.name;
  object.child_frame_id = frame + "_" + std::to_string(tracked.frame_index);
  if (tracked.is_best) object.stable_frame_id = frame;
  return object;
}

void DetectionPipeline::wait_for_tf(const std_msgs::Header& header) const {
  const std::string camera = camera_frame_of(config_.platform, header);
  for (const auto* frame : {&config_.platform.platform_frame, &config_.target_frame})
    if (!frame->empty()) wait_for_transform(tf_, *frame, camera, header.stamp, config_.tf_wait);
}

std::string DetectionPipeline::to_target_frame(DetectedObjectArray& array) const {
  if (config_.target_frame.empty() || config_.target_frame == array.header.frame_id) return "";
  try {
    const auto transform =
        tf_.lookupTransform(config_.target_frame, array.header.frame_id, array.header.stamp);
    for (auto& object : array.objects)
      if (object.pose_valid) transform_poses(object, transform);
    array.header.frame_id = config_.target_frame;
    return "";
  } catch (const tf2::TransformException& error) {
    // The fault sets the status TF_UNAVAILABLE, so that no frame is sent: a frame must not change
    // its parent between camera and target_frame.
    return "target_frame: " + tf_fault(error);
  }
}

}  // namespace mbncc::nodelets
