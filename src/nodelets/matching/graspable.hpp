// SPDX-License-Identifier: BSD-3-Clause
// Selects the graspable objects of an array, for programs that do not evaluate states.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <vector>

namespace mbncc::nodelets {

/// Pointers to objects of an array, in its order; the array must outlive them.
using ObjectList = std::vector<const mbncc_vision::DetectedObject*>;

/// Whether a robot may be moved by the array's poses in metres.
inline bool is_reliable(const mbncc_vision::DetectedObjectArray& detections) {
  return detections.status == detections.OK || detections.status == detections.BUDGET_EXCEEDED;
}

/// The CONFIRMED objects. Their poses are valid at least in pixels.
inline ObjectList confirmed(const mbncc_vision::DetectedObjectArray& detections) {
  ObjectList objects;
  if (!is_reliable(detections) && detections.status != detections.UNCALIBRATED &&
      detections.status != detections.TF_UNAVAILABLE)
    return objects;
  for (const auto& object : detections.objects)
    if (object.state == object.CONFIRMED) objects.push_back(&object);
  return objects;
}

/// The CONFIRMED objects with a usable pose in metres.
inline ObjectList graspable(const mbncc_vision::DetectedObjectArray& detections) {
  ObjectList objects;
  if (!is_reliable(detections)) return objects;
  for (const auto* object : confirmed(detections))
    if (object->pose_valid) objects.push_back(object);
  return objects;
}

}  // namespace mbncc::nodelets
