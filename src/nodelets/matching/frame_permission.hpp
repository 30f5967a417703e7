// SPDX-License-Identifier: BSD-3-Clause
// Decides which tf frames may be sent: the only place that does. Every array passes here before it
// leaves the nodelet.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

namespace mbncc::nodelets {

/// Removes the frame ids of all objects but the graspable ones (graspable.hpp) with a finite pose;
/// of all if frames are not `wanted`: publish_tf is off, or the array answers a service, whose
/// instances are not those of the stream.
void keep_permitted_frames(mbncc_vision::DetectedObjectArray& array, bool wanted);

}  // namespace mbncc::nodelets
