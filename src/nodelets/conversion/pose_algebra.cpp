// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/pose_algebra.hpp"

#include <cmath>

#include <tf2/LinearMath/Transform.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

namespace mbncc::nodelets {
namespace {

tf2::Transform transform_of(const geometry_msgs::Pose& pose) {
  tf2::Transform transform;
  tf2::fromMsg(pose, transform);
  return transform;
}

geometry_msgs::Pose pose_of(const tf2::Transform& transform) {
  geometry_msgs::Pose pose;
  tf2::toMsg(transform, pose);
  return pose;
}

}  // namespace

geometry_msgs::Pose compose(const geometry_msgs::Pose& b_in_a, const geometry_msgs::Pose& c_in_b) {
  return pose_of(transform_of(b_in_a) * transform_of(c_in_b));
}

geometry_msgs::Pose inverse(const geometry_msgs::Pose& b_in_a) {
  return pose_of(transform_of(b_in_a).inverse());
}

bool is_finite(const geometry_msgs::Pose& pose) {
  return std::isfinite(pose.position.x + pose.position.y + pose.position.z) &&
         std::isfinite(pose.orientation.x + pose.orientation.y + pose.orientation.z +
                       pose.orientation.w);
}

geometry_msgs::Pose half_turn_about_x() {
  geometry_msgs::Pose turn;
  turn.orientation.x = 1;
  return turn;
}

}  // namespace mbncc::nodelets
