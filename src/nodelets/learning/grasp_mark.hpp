// SPDX-License-Identifier: BSD-3-Clause
// Records the gripper's pose at the demonstration as the object's grasp.
#pragma once

#include <ros/time.h>
#include <tf2_ros/buffer.h>

#include <Eigen/Geometry>
#include <mutex>
#include <optional>
#include <string>

#include "mbncc/object_model.hpp"

namespace mbncc::nodelets {

class GraspMark {
 public:
  /// `tf` outlives the mark; `gripper_frame` "" refuses every mark.
  GraspMark(const tf2_ros::Buffer& tf, std::string gripper_frame);

  /// Stores the gripper's pose at `now` in `base_frame`, which must not move relative to the
  /// platform until the object is known. Throws std::runtime_error with a message if the pose is
  /// unknown.
  void record(const std::string& base_frame, const ros::Time& now);

  void clear();

  /// Whether a mark was recorded at `time` or later; an older one belongs to another demonstration.
  bool is_marked_since(const ros::Time& time) const;

  /// The marked gripper pose relative to an object's in the base frame; none if nothing is marked.
  std::optional<Grasp> relative_to(const Eigen::Isometry3d& T_base_object) const;

 private:
  const tf2_ros::Buffer& tf_;
  const std::string gripper_frame_;
  mutable std::mutex mutex_;
  std::optional<Eigen::Isometry3d> T_base_gripper_;
  ros::Time recorded_at_;
};

}  // namespace mbncc::nodelets
