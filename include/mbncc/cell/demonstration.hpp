// SPDX-License-Identifier: BSD-3-Clause
// Picks the two pictures of a live lesson out of what a SceneWatch sees: the still scene before,
// and the still scene in which something has changed inside the picture. A scene before that has
// become useless, by light, by a hand that was in it, by a moved camera, is taken anew.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/cell/scene_watch.hpp"

namespace mbncc {

class Demonstration {
 public:
  /// What the operator has to do, or that both pictures are there.
  enum class Step {
    kWaitStill,    ///< keep out of the picture: the scene before is not still yet
    kWaitRemoval,  ///< take the object away
    kMoving,       ///< something moves
    kAtBorder,     ///< something has come that reaches into the picture
    kReady
  };

  /// Why the scene before was taken anew.
  enum class Anew {
    kNot,
    kLight,       ///< the light has changed, nothing else
    kEdgeLeft,    ///< what reached out of the picture at the start has left
    kEverything,  ///< nearly the whole picture has changed
    kPutDown      ///< something was put down, or lies where it covers its old place
  };

  Demonstration() = default;

  /// With a picture before that is given; only the scene after is waited for.
  explicit Demonstration(const cv::Mat& before) { before_.picture = before; }

  /// Takes another look at the scene; `still` as SceneWatch tells it. Pictures of another size
  /// than the one before are as good as none.
  Step look(const std::optional<StillShot>& still);

  /// Nothing had left: the operator is at it yet, or something was put down, which belongs to the
  /// scene before from now on; a given picture stays. More looks are needed.
  void go_on();

  /// The last reason; kPutDown after go_on().
  Anew anew() const { return anew_; }

  const StillShot& before() const { return before_; }  ///< once look() has asked for the removal
  const StillShot& after() const { return after_; }    ///< once look() has said kReady

 private:
  Step judge(const StillShot& still);
  void compare(const StillShot& still);

  StillShot before_, after_;
  std::uint64_t seen_ = 0;  // still period judged last
  double compared_at_ = 0;  // [s] stamp of the picture judged last
  SceneChange change_ = SceneChange::kNone;
  Anew anew_ = Anew::kNot;
};

}  // namespace mbncc
