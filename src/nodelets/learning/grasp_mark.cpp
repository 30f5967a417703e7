// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/grasp_mark.hpp"

#include <tf2_eigen/tf2_eigen.h>

#include <stdexcept>
#include <utility>

namespace mbncc::nodelets {
namespace {

constexpr double kOldestPose = 0.5;  // [s] largest age of the gripper's pose

}  // namespace

GraspMark::GraspMark(const tf2_ros::Buffer& tf, std::string gripper_frame)
    : tf_(tf), gripper_frame_(std::move(gripper_frame)) {}

void GraspMark::record(const std::string& base_frame, const ros::Time& now) {
  if (gripper_frame_.empty())
    throw std::runtime_error("no grasp can be marked: set the parameter gripper_frame");
  if (base_frame.empty())
    throw std::runtime_error(
        "no grasp can be marked: the images have no frame_id, set camera_frame");
  try {
    const auto pose = tf_.lookupTransform(base_frame, gripper_frame_, ros::Time(0));
    const ros::Time& stamp = pose.header.stamp;
    // A static transform has no stamp.
    if (!stamp.isZero() && (now - stamp).toSec() > kOldestPose)
      throw std::runtime_error("no grasp can be marked: the last pose of '" + gripper_frame_ +
                               "' is too old; check that the robot publishes its tf");
    const std::lock_guard<std::mutex> lock(mutex_);
    T_base_gripper_ = tf2::transformToEigen(pose);
    recorded_at_ = now;
  } catch (const tf2::TransformException& error) {
    throw std::runtime_error(std::string("no grasp can be marked: ") + error.what());
  }
}

void GraspMark::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  T_base_gripper_.reset();
}

bool GraspMark::is_marked() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return T_base_gripper_.has_value();
}

bool GraspMark::is_marked_since(const ros::Time& time) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  // A mark in the future was recorded before the clock jumped back.
  return T_base_gripper_ && recorded_at_ >= time && recorded_at_ <= ros::Time::now();
}

std::optional<Grasp> GraspMark::relative_to(const Eigen::Isometry3d& T_base_object) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!T_base_gripper_) return {};
  const Eigen::Isometry3d T_object_gripper = T_base_object.inverse() * *T_base_gripper_;
  const Eigen::Vector3d t = T_object_gripper.translation();
  const Eigen::Quaterniond q(T_object_gripper.linear());
  return Grasp{{{t.x(), t.y(), t.z()}}, {{q.x(), q.y(), q.z(), q.w()}}};
}

}  // namespace mbncc::nodelets
