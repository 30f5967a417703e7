// SPDX-License-Identifier: BSD-3-Clause
// Converts the simulated camera's parameters to the configurations of scene and script.
#pragma once

#include "mbncc/config/simulated_camera_config.hpp"
#include "mbncc/sim/cell_script.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::sim {

SceneConfig scene_config(const SimulatedCameraConfig& config);

/// Times are converted to numbers of images at `frame_rate`, at least one.
CellScriptConfig script_config(const SimulatedCameraConfig& config);

}  // namespace mbncc::sim
