// SPDX-License-Identifier: BSD-3-Clause
// Detections as vision_msgs has them.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <vision_msgs/Detection2DArray.h>
#include <vision_msgs/Detection3DArray.h>

#include <cstdint>
#include <map>
#include <string>

namespace mbncc::nodelets {

/// vision_msgs knows objects by number. A name's is the CRC-32 of its bytes without the highest
/// bit: the same in every cell, in every run, and whatever else is in the library.
std::int64_t object_id(const std::string& name);

/// The names that numbers stand for.
class ObjectIds {
 public:
  /// Takes the names of an array in; true when there was a new one among them.
  bool add(const mbncc_vision::DetectedObjectArray& detections);

  /// False for a name that is not known, or whose number another name had first: no message can
  /// tell of it.
  bool has(const std::string& name) const;

  /// By number.
  const std::map<std::int64_t, std::string>& names() const { return names_; }

 private:
  bool add(const std::string& name);

  std::map<std::int64_t, std::string> names_;
};

/// What is confirmed(). The box lies along the object's axes around its outline; [px], rotated
/// clockwise on the screen. Without a pose in metres that of the hypothesis is all zeros.
vision_msgs::Detection2DArray to_detections_2d(const mbncc_vision::DetectedObjectArray& detections,
                                               const ObjectIds& ids);

/// What is graspable(). The box lies along the object's axes around its body,
/// between the footprint and the top face; its size is 0 where the scale is unknown.
vision_msgs::Detection3DArray to_detections_3d(const mbncc_vision::DetectedObjectArray& detections,
                                               const ObjectIds& ids);

}  // namespace mbncc::nodelets
