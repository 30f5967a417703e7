// SPDX-License-Identifier: BSD-3-Clause
// Every parameter of the package: one list serves --config, --set and `mbncc params`.
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

/// The settings of the nodelets hold those of the core.
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

/// --config and --set.
std::vector<Option> settings_options();

/// Defaults, changed by --config FILE and then by --set key=value. One that several parts have,
/// each with a range of its own, is set in every part that takes it. Throws UsageError, ConfigError
/// (no part takes it), FileError.
Settings settings_from(const Arguments& arguments);

/// The simulated camera's alone of those: what it does not take is refused whatever other parts do.
SimulatedCameraConfig simulated_camera_from(const Arguments& arguments);

}  // namespace mbncc::cli
