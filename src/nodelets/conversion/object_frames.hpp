// SPDX-License-Identifier: BSD-3-Clause
// The tf frames of confirmed instances: all of one image together, at its stamp, and never twice
// for a stamp.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/time.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mbncc::nodelets {

class ObjectFrames {
 public:
  /// [ns] after its last transform a stable frame is at another instance. Python's tf2 keeps stamps
  /// as doubles, which tell 240 ns apart at today's time.
  static constexpr int kStep = 1000;

  /// The frames child_frame_id and stable_frame_id of each object that has them, and ..._grasp
  /// under them if it has a finite grasp; none for a stamp that is not after the last one. Which
  /// objects have them, permit_frames() decides. A stable frame switches to another
  /// instance in one step, so that a look-up between two stamps finds no intermediate pose.
  std::vector<geometry_msgs::TransformStamped> of(
      const mbncc_vision::DetectedObjectArray& detections);

  /// The clock has jumped back: older stamps are accepted again.
  void reset();

 private:
  struct Followed {
    std::uint32_t instance_id = 0;
    ros::Time stamp;  // of its last transform
  };

  ros::Time last_;
  std::map<std::string, Followed> followed_;  // by stable frame
};

}  // namespace mbncc::nodelets
