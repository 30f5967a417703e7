// SPDX-License-Identifier: BSD-3-Clause
// All parameters of the package; the same list serves --config, --set and `mbncc params`.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "mbncc/config/camera_config.hpp"
#include "mbncc/config/learning_node_config.hpp"
#include "mbncc/config/matching_node_config.hpp"
#include "mbncc/config/rectify_config.hpp"
#include "mbncc/config/simulated_camera_config.hpp"

namespace mbncc::cli {

/// The settings of the nodelets include those of the core.
struct Settings {
  MatchingNodeConfig matching;
  LearningNodeConfig learning;
  CameraConfig camera;
  RectifyConfig rectify;
  SimulatedCameraConfig simulated_camera;

  SearchConfig& search() { return matching.search; }
  LearningConfig& lesson() { return learning.learning; }
};

/// The parameters of one part of the package.
struct SettingsSection {
  std::string title;
  std::vector<FieldRow> rows;
};

/// All parameters by part. `settings` must outlive the rows.
std::vector<SettingsSection> sections_of(Settings& settings);

/// The options --config and --set.
std::vector<Option> settings_options();

/// Applies --config FILE and then --set key=value. A parameter that several parts share, each with
/// its own range, is set in every part that accepts the value. Throws UsageError, ConfigError (if
/// no part accepts the value), FileError.
void change_settings(Settings& settings, const Arguments& arguments);

/// The defaults, changed in this way.
Settings settings_from(const Arguments& arguments);

/// Sets only the simulated camera's parameters: a value that it does not accept is refused even if
/// other parts accept it.
SimulatedCameraConfig simulated_camera_from(const Arguments& arguments);

}  // namespace mbncc::cli
