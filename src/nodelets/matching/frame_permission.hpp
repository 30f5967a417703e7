// SPDX-License-Identifier: BSD-3-Clause
// Decides which tf frames may be sent: the only place that does. Every array passes here before it
// leaves the nodelet.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/time.h>

namespace mbncc::nodelets {

/// Fills in the latency of an array that leaves `now`. Objects that are too old by then are no
/// longer confirmed. Removes the frame ids of all objects but the graspable ones (graspable.hpp)
/// with a finite pose; of all if frames are not `wanted`: publish_tf is off, or the array answers a
/// service, whose instances are not those of the stream.
void permit_frames(mbncc_vision::DetectedObjectArray& array, const ros::Time& now, bool wanted);

}  // namespace mbncc::nodelets
