// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera's parameters as the scene and the story that they describe.
#pragma once

#include "mbncc/config/simulated_camera_config.hpp"
#include "mbncc/sim/cell_script.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::sim {

SceneConfig scene_config(const SimulatedCameraConfig& config);

/// Times become pictures at `frame_rate`, one at least.
CellScriptConfig script_config(const SimulatedCameraConfig& config);

}  // namespace mbncc::sim
