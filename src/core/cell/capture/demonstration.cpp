// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/demonstration.hpp"

#include "mbncc/cell/part_put_down.hpp"

namespace mbncc {
namespace {

constexpr double kAgain = 1;           // [s] interval at which a still scene is compared again
constexpr double kOtherLight = 1.15;   // exposure ratio above which the image before is replaced
constexpr double kMostOfImage = 0.45;  // changed part of the image; if larger, the scene is new

/// Whether `changed` shows something that was in the image before and has disappeared.
bool has_left(const cv::Mat& changed, const StillShot& before, const StillShot& after) {
  constexpr double kMostly = 0.5;  // with swapped images, what has left looks like an arrival
  return part_put_down(changed, after.image, before.image) > kMostly;
}

}  // namespace

Demonstration::Step Demonstration::update(const std::optional<StillShot>& still) {
  if (before_.image.empty()) {
    if (!still) return Step::kWaitStill;
    before_ = *still;
    seen_ = before_.number;
    compared_at_ = before_.stamp;
    return Step::kWaitRemoval;
  }
  return still ? judge(*still) : Step::kMoving;
}

/// A still period is evaluated at its start and then every kAgain seconds.
Demonstration::Step Demonstration::judge(const StillShot& still) {
  const bool due = still.number > seen_ || still.stamp - compared_at_ >= kAgain;
  if (due && still.image.size() == before_.image.size()) {
    seen_ = still.number;
    compared_at_ = still.stamp;
    compare(still);
  }
  if (change_ == SceneChange::kInside) return Step::kReady;
  return change_ == SceneChange::kAtBorder ? Step::kAtBorder : Step::kWaitRemoval;
}

void Demonstration::compare(const StillShot& still) {
  const SceneDifference difference = scene_difference(before_.image, still.image);
  change_ = difference.change;
  if (change_ == SceneChange::kInside) after_ = still;
  const bool given = before_.number == 0;
  if (given || change_ == SceneChange::kInside) return;
  RestartReason why = RestartReason::kNone;
  if (change_ == SceneChange::kNone && difference.exposure > kOtherLight)
    why = RestartReason::kLight;
  else if (difference.fraction > kMostOfImage)
    why = RestartReason::kEverything;
  else if (change_ == SceneChange::kAtBorder && has_left(difference.changed, before_, still))
    why = RestartReason::kEdgeLeft;
  if (why == RestartReason::kNone) return;
  restart_reason_ = why;
  before_ = still;
  change_ = SceneChange::kNone;
}

void Demonstration::continue_waiting() {
  const bool given = before_.number == 0;
  if (!given) before_ = after_;
  change_ = SceneChange::kNone;
  restart_reason_ = RestartReason::kPutDown;
}

}  // namespace mbncc
