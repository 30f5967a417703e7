// The tf frames of confirmed instances: all of a picture in one message, at its stamp, never twice
// for a stamp.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/time.h>
#include <tf2_ros/transform_broadcaster.h>

#include "mbncc/library/object_library.hpp"

namespace mbncc::nodelets {

class TfSender {
 public:
  /// Sends a frame for each object whose child_frame_id is set, and its ..._grasp where `library`
  /// holds a grasp. Objects without a finite metric pose are left out, whatever they claim.
  void send(const mbncc_vision::DetectedObjectArray& detections, const LibrarySnapshot& library);

  /// The clock has jumped back: older stamps are new again.
  void reset() { last_ = ros::Time(); }

 private:
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Time last_;
};

}  // namespace mbncc::nodelets
