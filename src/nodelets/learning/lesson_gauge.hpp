// SPDX-License-Identifier: BSD-3-Clause
// Determines the metric data of a lesson, scale and grasp, from the calibration and tf.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/object_model.hpp"
#include "nodelets/common/camera_input.hpp"
#include "nodelets/conversion/calibration.hpp"
#include "nodelets/learning/grasp_mark.hpp"

namespace mbncc::nodelets {

/// Metric data of an object.
struct LessonMeasures {
  double metres_per_pixel = Quality::kUnknown;
  std::optional<Grasp> grasp;
  bool marked = false;          ///< a grasp was marked in this demonstration
  bool marked_earlier = false;  ///< a grasp was marked, but in another demonstration
  std::string fault;            ///< why scale or a marked grasp is missing although it is wanted
};

class LessonGauge {
 public:
  /// `camera` and `tf` must outlive this object.
  LessonGauge(const PlatformConfig& config, const std::string& gripper_frame, CameraInput& camera,
              const tf2_ros::Buffer& tf);

  /// Stores the gripper's current pose until a lesson is stored. Throws std::runtime_error with a
  /// message if it cannot become a grasp.
  void mark(const std_msgs::Header& newest_image);

  /// The calibration at the stamp of a lesson's image. Call this when the image is taken, because
  /// tf stores only some seconds and a lesson lasts minutes. `given` is the goal's camera_info; if
  /// it is empty, the live one is used.
  Calibration calibrate_image(const sensor_msgs::CameraInfo& given, const std_msgs::Header& header,
                              cv::Size size) const;

  /// The metric data of an object that lies at `reference` in the image of the calibration, with
  /// its top face `object_height` [m] above the platform. Grasps marked before `since` are ignored,
  /// because they belong to another demonstration.
  LessonMeasures measure(const Calibration& calibration, const ros::Time& since,
                         const Pose2D& reference, double object_height) const;

  /// Forgets the mark; call this when the lesson has been stored with it.
  void clear() { mark_.clear(); }

 private:
  const PlatformConfig config_;
  CameraInput& camera_;
  const tf2_ros::Buffer& tf_;
  GraspMark mark_;
};

}  // namespace mbncc::nodelets
