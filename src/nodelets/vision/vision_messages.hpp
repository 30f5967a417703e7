// SPDX-License-Identifier: BSD-3-Clause
// Converts detections to vision_msgs.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <vision_msgs/Detection2DArray.h>
#include <vision_msgs/Detection3DArray.h>

#include <cstdint>
#include <map>
#include <string>

namespace mbncc::nodelets {

/// vision_msgs identifies objects by number. The number of a name is the CRC-32 of its bytes
/// without the highest bit: the same in every cell and run, independent of the library.
std::int64_t object_id(const std::string& name);

/// Maps numbers to names.
class ObjectIds {
 public:
  /// Adds the names of an array; true if one was new.
  bool add(const mbncc_vision::DetectedObjectArray& detections);

  /// False for a name that is unknown, or whose number is already used by another name and cannot
  /// be published.
  bool has(const std::string& name) const;

  /// By number.
  const std::map<std::int64_t, std::string>& names() const { return names_; }

 private:
  bool add(const std::string& name);

  std::map<std::int64_t, std::string> names_;
};

/// The confirmed() objects. The box around the outline is aligned with the object's axes; [px],
/// rotated clockwise on the screen. Without a pose in metres, the pose of the hypothesis is zero.
vision_msgs::Detection2DArray to_detections_2d(const mbncc_vision::DetectedObjectArray& detections,
                                               const ObjectIds& ids);

/// The graspable() objects. The box around the body is aligned with the object's axes, between the
/// footprint and the top face; its size is 0 if the scale is unknown.
vision_msgs::Detection3DArray to_detections_3d(const mbncc_vision::DetectedObjectArray& detections,
                                               const ObjectIds& ids);

}  // namespace mbncc::nodelets
