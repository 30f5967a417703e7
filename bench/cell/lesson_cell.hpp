// SPDX-License-Identifier: BSD-3-Clause
// The simulated cell as a lesson sees it: with flickering and drifting light, and arms that reach
// in.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/cell/scene_watch.hpp"
#include "mbncc/sim/cell_script.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {

constexpr int kPatience = 400;  ///< images until a lesson times out

/// The cell and its camera, one image at a time. `random` must outlive it.
class LessonCell {
 public:
  LessonCell(std::uint64_t seed, cv::RNG& random);

  /// Passes the next image to `watch`; `intruder` replaces the arm of the script.
  void show(const std::optional<sim::Arm>& intruder = {});

  void rest(int images);
  void finish_motion();

  /// Makes an arm reach in from below, pause and leave again.
  void reach_in();

  cv::Mat map_of(const Pose2D& pose) const { return scene_.true_map({object_, pose}); }
  cv::Mat image() { return scene_.render(script_.frame().placed, 77777 + frames_++); }
  sim::CellScript& script() { return script_; }

  SceneWatch watch{0.5};

 private:
  sim::CellScriptConfig script_config(std::uint64_t seed, cv::RNG& random);

  cv::RNG& random_;
  sim::SceneObject object_;
  sim::Scene scene_;
  sim::CellScript script_;
  std::uint64_t frames_ = 0;
  double drift_ = 0, phase_ = 0;
};

}  // namespace mbncc::bench
