// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/object_frames.hpp"

#include <string>
#include <vector>

#include "nodelets/conversion/pose_algebra.hpp"

namespace mbncc::nodelets {
namespace {

geometry_msgs::TransformStamped transform_of(const ros::Time& stamp, const std::string& parent,
                                             const std::string& child,
                                             const geometry_msgs::Pose& pose) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.position.x;
  transform.transform.translation.y = pose.position.y;
  transform.transform.translation.z = pose.position.z;
  transform.transform.rotation = pose.orientation;
  return transform;
}

}  // namespace

std::vector<geometry_msgs::TransformStamped> ObjectFrames::transforms_of(
    const mbncc_vision::DetectedObjectArray& detections) {
  const ros::Time& stamp = detections.header.stamp;
  std::vector<geometry_msgs::TransformStamped> transforms;
  if (stamp <= last_) return transforms;
  for (const auto& object : detections.objects) {
    const auto add = [&](const ros::Time& at, const std::string& frame) {
      transforms.push_back(transform_of(at, detections.header.frame_id, frame, object.pose.pose));
      if (object.has_grasp && is_finite(object.grasp))
        transforms.push_back(transform_of(at, frame, frame + "_grasp",
                                          compose(inverse(object.pose.pose), object.grasp)));
    };
    if (!object.child_frame_id.empty()) add(stamp, object.child_frame_id);
    if (object.stable_frame_id.empty()) continue;
    LastTransform& last = last_transforms_[object.stable_frame_id];
    // tf interpolates: without an earlier transform at the new pose, the frame would seem to move
    // from the last instance to this one.
    const ros::Time next = last.stamp + ros::Duration(0, kStep);
    if (last.instance_id != 0 && last.instance_id != object.instance_id && next < stamp)
      add(next, object.stable_frame_id);
    add(stamp, object.stable_frame_id);
    last = {object.instance_id, stamp};
  }
  if (!transforms.empty()) last_ = stamp;
  return transforms;
}

void ObjectFrames::reset() {
  last_ = ros::Time();
  last_transforms_.clear();
}

}  // namespace mbncc::nodelets
