// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/sim/cell_config.hpp"

#include <algorithm>

namespace mbncc::sim {
namespace {

int frames(double seconds, double frame_rate) {
  return std::max(1, cvRound(seconds * frame_rate));
}

}  // namespace

SceneConfig scene_config(const SimulatedCameraConfig& config) {
  SceneConfig scene;
  scene.size = {config.width, config.height};
  scene.seed = static_cast<std::uint64_t>(config.seed);
  scene.noise_sigma = config.noise_sigma;
  scene.light_gradient = config.light_gradient;
  scene.gain = config.gain;
  return scene;
}

CellScriptConfig script_config(const SimulatedCameraConfig& config) {
  CellScriptConfig script;
  script.size = {config.width, config.height};
  script.seed = static_cast<std::uint64_t>(config.seed);
  script.object = {static_cast<std::uint64_t>(config.object_seed), config.object_diameter,
                   config.object_elongation};
  script.neighbours = config.neighbours;
  script.auto_play = config.auto_play;
  script.rest_frames = frames(config.rest_time, config.frame_rate);
  script.leg_frames = frames(config.leg_time, config.frame_rate);
  return script;
}

}  // namespace mbncc::sim
