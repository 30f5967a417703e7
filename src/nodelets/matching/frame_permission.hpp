// SPDX-License-Identifier: BSD-3-Clause
// Decides which tf frames may be sent. Nothing else decides this: every array passes through here
// before it leaves the nodelet.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/time.h>

namespace mbncc::nodelets {

/// Fills in the latency of an array that is published at `now`. Objects that are too old by then
/// are no longer confirmed. Removes the frame ids of all objects except the graspable ones
/// (graspable.hpp) with a finite pose. If frames are not `wanted`, removes all frame ids:
/// publish_tf is off, or the array answers a service call, whose instances are not those of the
/// stream.
void permit_frames(mbncc_vision::DetectedObjectArray& array, const ros::Time& now, bool wanted);

}  // namespace mbncc::nodelets
