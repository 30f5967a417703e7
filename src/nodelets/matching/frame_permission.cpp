// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/frame_permission.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "nodelets/conversion/pose_algebra.hpp"
#include "nodelets/matching/graspable.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

// Fills in the latency; an object that is too old at `now` is no longer confirmed.
void note_age(DetectedObjectArray& array, const ros::Time& now) {
  array.latency = static_cast<float>((now - array.header.stamp).toSec());
  for (auto& object : array.objects) {
    if (object.state != DetectedObject::CONFIRMED || now <= object.valid_until) continue;
    object.state = DetectedObject::NEW;
    const double valid = object.valid_until.toSec() - array.header.stamp.toSec();
    object.reasons = {"older than valid_until when it was published (valid for " +
                      std::to_string(std::lround(1000 * valid)) + " ms)"};
  }
}

void keep_permitted_frames(DetectedObjectArray& array, bool wanted) {
  const ObjectList allowed = wanted ? graspable(array) : ObjectList();
  for (auto& object : array.objects) {
    const bool found = std::find(allowed.begin(), allowed.end(), &object) != allowed.end();
    if (found && is_finite(object.pose.pose)) continue;
    object.child_frame_id.clear();
    object.stable_frame_id.clear();
  }
}

}  // namespace

void permit_frames(DetectedObjectArray& array, const ros::Time& now, bool wanted) {
  note_age(array, now);
  keep_permitted_frames(array, wanted);
}

}  // namespace mbncc::nodelets
