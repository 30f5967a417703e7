#include "nodelets/tf_sender.hpp"

#include <geometry_msgs/TransformStamped.h>

#include <cmath>
#include <string>
#include <vector>

#include "nodelets/messages.hpp"

namespace mbncc::nodelets {
namespace {

bool is_finite(const geometry_msgs::Pose& pose) {
  return std::isfinite(pose.position.x + pose.position.y + pose.position.z) &&
         std::isfinite(pose.orientation.x + pose.orientation.y + pose.orientation.z +
                       pose.orientation.w);
}

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

void TfSender::send(const mbncc_vision::DetectedObjectArray& detections,
                    const LibrarySnapshot& library) {
  const ros::Time& stamp = detections.header.stamp;
  if (stamp <= last_) return;
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const auto& object : detections.objects) {
    const std::string& frame = object.child_frame_id;
    if (frame.empty() || !object.pose_valid || !is_finite(object.pose.pose)) continue;
    transforms.push_back(transform_of(stamp, detections.header.frame_id, frame, object.pose.pose));
    const auto model = library.find(object.name);
    if (model && model->grasp)
      transforms.push_back(transform_of(stamp, frame, frame + "_grasp", to_msg(*model->grasp)));
  }
  if (transforms.empty()) return;
  last_ = stamp;
  broadcaster_.sendTransform(transforms);
}

}  // namespace mbncc::nodelets
