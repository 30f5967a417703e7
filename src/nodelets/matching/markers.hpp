// SPDX-License-Identifier: BSD-3-Clause
// Detections as RViz markers.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <visualization_msgs/MarkerArray.h>

namespace mbncc::nodelets {

/// The outline in metres, the axes (x vermilion, y green) and a caption with the state for every
/// object with a pose in metres. The first marker is a DELETEALL, which removes lost objects.
/// Markers also expire without updates.
visualization_msgs::MarkerArray to_markers(const mbncc_vision::DetectedObjectArray& detections);

}  // namespace mbncc::nodelets
