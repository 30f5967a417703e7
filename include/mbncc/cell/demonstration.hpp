// SPDX-License-Identifier: BSD-3-Clause
// Selects the two images of a live lesson from a SceneWatch: the still scene before, and the
// still scene in which something has changed inside the image. The scene before is replaced when
// it becomes useless because the light changed, a hand was in it, or the camera was moved.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/cell/scene_difference.hpp"
#include "mbncc/cell/scene_watch.hpp"

namespace mbncc {

class Demonstration {
 public:
  /// What the operator must do, or that both images are available.
  enum class Step {
    kWaitStill,    ///< keep out of the image: the scene before is not still yet
    kWaitRemoval,  ///< take the object away
    kMoving,       ///< something moves
    kAtBorder,     ///< something new reaches into the image from its border
    kReady
  };

  /// Why the scene before was replaced.
  enum class RestartReason {
    kNone,
    kLight,       ///< only the light has changed
    kEdgeLeft,    ///< something that crossed the image's border at the start has left
    kEverything,  ///< nearly the whole image has changed
    kPutDown      ///< something was put down, or the object partly covers its old place
  };

  Demonstration() = default;

  /// Starts from a given image before; only the scene after is awaited.
  explicit Demonstration(const cv::Mat& before) { before_.image = before; }

  /// Processes the next image; `still` is SceneWatch::still(). Images of another size than the
  /// one before are ignored.
  Step update(const std::optional<StillShot>& still);

  /// Continues after kReady if no object has left: the operator is not done, or something was put
  /// down, which then belongs to the scene before. An image that was passed to the constructor is
  /// kept. Call update() again.
  void continue_waiting();

  /// Why the scene before was last replaced; kPutDown after continue_waiting().
  RestartReason restart_reason() const { return restart_reason_; }

  /// Valid once update() has returned kWaitRemoval.
  const StillShot& before() const { return before_; }
  /// Valid once update() has returned kReady.
  const StillShot& after() const { return after_; }

 private:
  Step judge(const StillShot& still);
  void compare(const StillShot& still);

  StillShot before_, after_;
  std::uint64_t seen_ = 0;  // still period that was compared last
  double compared_at_ = 0;  // [s] stamp of the image that was compared last
  SceneChange change_ = SceneChange::kNone;
  RestartReason restart_reason_ = RestartReason::kNone;
};

}  // namespace mbncc
