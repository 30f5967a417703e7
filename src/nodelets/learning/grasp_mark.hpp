// SPDX-License-Identifier: BSD-3-Clause
// Records the gripper's pose during the demonstration as the object's grasp.
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
  /// `tf` must outlive this object. If `gripper_frame` is "", no grasp can be recorded.
  GraspMark(const tf2_ros::Buffer& tf, std::string gripper_frame);

  /// Stores the gripper's pose at `now` in `base_frame`, which must not move relative to the
  /// platform until the object's pose is known. Throws std::runtime_error with a message if the
  /// pose is unknown.
  void record(const std::string& base_frame, const ros::Time& now);

  void clear();

  bool is_marked() const;

  /// Whether a mark was recorded at `time` or later; an older one belongs to another demonstration.
  bool is_marked_since(const ros::Time& time) const;

  /// The marked pose of the gripper relative to the object, whose pose in the base frame is given;
  /// none if nothing is marked.
  std::optional<Grasp> relative_to(const Eigen::Isometry3d& T_base_object) const;

 private:
  const tf2_ros::Buffer& tf_;
  const std::string gripper_frame_;
  mutable std::mutex mutex_;
  std::optional<Eigen::Isometry3d> T_base_gripper_;
  ros::Time recorded_at_;
};

}  // namespace mbncc::nodelets
