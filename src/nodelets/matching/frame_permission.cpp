// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/frame_permission.hpp"

#include <algorithm>

#include "nodelets/conversion/pose_algebra.hpp"
#include "nodelets/matching/graspable.hpp"

namespace mbncc::nodelets {

void keep_permitted_frames(mbncc_vision::DetectedObjectArray& array, bool wanted) {
  const ObjectList allowed = wanted ? graspable(array) : ObjectList();
  for (auto& object : array.objects) {
    const bool found = std::find(allowed.begin(), allowed.end(), &object) != allowed.end();
    if (found && is_finite(object.pose.pose)) continue;
    object.child_frame_id.clear();
    object.stable_frame_id.clear();
  }
}

}  // namespace mbncc::nodelets
