#include "mbncc/cell/demonstration.hpp"

namespace mbncc {

Demonstration::Step Demonstration::look(const std::optional<StillShot>& still) {
  if (before_.picture.empty()) {
    if (!still) return Step::kWaitStill;
    before_ = *still;
    seen_ = before_.number;
    return Step::kWaitRemoval;
  }
  return still ? judge(*still) : Step::kMoving;
}

/// A still period is judged once.
Demonstration::Step Demonstration::judge(const StillShot& still) {
  if (still.number > seen_ && still.picture.size() == before_.picture.size()) {
    seen_ = still.number;
    change_ = scene_change(before_.picture, still.picture);
    if (change_ == SceneChange::kInside) after_ = still;
  }
  if (change_ == SceneChange::kInside) return Step::kReady;
  return change_ == SceneChange::kAtBorder ? Step::kAtBorder : Step::kWaitRemoval;
}

void Demonstration::go_on() {
  const bool given = before_.number == 0;
  if (!given) before_ = after_;
  change_ = SceneChange::kNone;
}

}  // namespace mbncc
