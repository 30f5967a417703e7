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

/// The number of an object for vision_msgs, which identifies objects by number: the CRC-32 of the
/// name's bytes without the highest bit. It is the same in every cell and run and does not depend
/// on the library.
std::int64_t object_id(const std::string& name);

/// Maps numbers to names.
class ObjectIds {
 public:
  /// Adds the names of an array; true if one was new.
  bool add(const mbncc_vision::DetectedObjectArray& detections);

  /// False for a name that is unknown, or whose number is already used by another name and cannot
  /// be published.
  bool has(const std::string& name) const;

  /// The names by number.
  const std::map<std::int64_t, std::string>& names() const { return names_; }

 private:
  bool add(const std::string& name);

  std::map<std::int64_t, std::string> names_;
};

/// Converts the confirmed() objects. The box [px] around the outline is aligned with the object's
/// axes; its angle is clockwise on the screen. Without a pose in metres, the pose of the hypothesis
/// is zero.
vision_msgs::Detection2DArray to_detections_2d(const mbncc_vision::DetectedObjectArray& detections,
                                               const ObjectIds& ids);

/// Converts the graspable() objects. The box [m] around the body is aligned with the object's axes,
/// between the footprint and the top face; its size is 0 if the scale is unknown.
vision_msgs::Detection3DArray to_detections_3d(const mbncc_vision::DetectedObjectArray& detections,
                                               const ObjectIds& ids);

}  // namespace mbncc::nodelets
