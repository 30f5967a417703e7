// SPDX-License-Identifier: BSD-3-Clause
// What of an array counts for a program that knows no states.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <vector>

namespace mbncc::nodelets {

/// Objects of an array, which has to outlive them, in its order.
using ObjectList = std::vector<const mbncc_vision::DetectedObject*>;

/// Whether the array's poses in metres are a ground to move on.
inline bool is_reliable(const mbncc_vision::DetectedObjectArray& detections) {
  return detections.status == detections.OK || detections.status == detections.BUDGET_EXCEEDED;
}

/// The objects that are CONFIRMED, in pixels at least.
inline ObjectList confirmed(const mbncc_vision::DetectedObjectArray& detections) {
  ObjectList objects;
  if (!is_reliable(detections) && detections.status != detections.UNCALIBRATED &&
      detections.status != detections.TF_UNAVAILABLE)
    return objects;
  for (const auto& object : detections.objects)
    if (object.state == object.CONFIRMED) objects.push_back(&object);
  return objects;
}

/// Those of them with a pose in metres to move on.
inline ObjectList graspable(const mbncc_vision::DetectedObjectArray& detections) {
  ObjectList objects;
  if (!is_reliable(detections)) return objects;
  for (const auto* object : confirmed(detections))
    if (object->pose_valid) objects.push_back(object);
  return objects;
}

}  // namespace mbncc::nodelets
