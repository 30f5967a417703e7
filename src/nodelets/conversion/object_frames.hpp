// SPDX-License-Identifier: BSD-3-Clause
// Makes the tf frames of confirmed instances: all frames of an image together, at its stamp, and
// never twice for the same stamp.
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
  /// [ns] between the last transform of a stable frame at one instance and the first one at the
  /// next. Python's tf2 stores stamps as doubles, whose resolution is about 240 ns for current
  /// times.
  static constexpr int kStep = 1000;

  /// The transforms of child_frame_id and stable_frame_id of each object that has them, and of
  /// their child frames ..._grasp if it has a finite grasp. None if the stamp is not after the last
  /// one. permit_frames() decides which objects have frames. A stable frame switches to another
  /// instance in one step, so that a look-up between two stamps finds no intermediate pose.
  std::vector<geometry_msgs::TransformStamped> transforms_of(
      const mbncc_vision::DetectedObjectArray& detections);

  /// Call this when the clock has jumped back: older stamps are accepted again.
  void reset();

 private:
  struct LastTransform {
    std::uint32_t instance_id = 0;
    ros::Time stamp;  // stamp of its last transform
  };

  ros::Time last_;
  std::map<std::string, LastTransform> last_transforms_;  // by name of the stable frame
};

}  // namespace mbncc::nodelets
