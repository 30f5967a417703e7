// What calibration and tf tell of a lesson: the scale, and where the gripper took the object.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>

#include <string>

#include "mbncc/object_model.hpp"
#include "nodelets/calibration.hpp"
#include "nodelets/camera_input.hpp"
#include "nodelets/grasp_mark.hpp"

namespace mbncc::nodelets {

/// The picture an object was learned from.
struct LessonShot {
  const sensor_msgs::CameraInfo& given;  ///< with the goal; empty: the live one counts
  const std_msgs::Header& header;
  ros::Time since;  ///< grasps marked earlier belong to another demonstration
};

class LessonGauge {
 public:
  /// `camera` and `tf` outlive the gauge.
  LessonGauge(const PlatformConfig& config, const std::string& gripper_frame,
              const CameraInput& camera, const tf2_ros::Buffer& tf);

  /// Keeps the gripper's present pose until a lesson is stored. Throws std::runtime_error with a
  /// sentence when it could not become a grasp.
  void mark(const std_msgs::Header& newest_picture);

  /// Fills in scale and grasp of the model's first view. Returns why a marked grasp had to be left
  /// out; "" otherwise.
  std::string measure(const LessonShot& shot, ObjectModel& model) const;

  /// The lesson is stored, and the mark with it.
  void clear() { mark_.clear(); }

 private:
  const PlatformConfig config_;
  const CameraInput& camera_;
  const tf2_ros::Buffer& tf_;
  GraspMark mark_;
};

}  // namespace mbncc::nodelets
