// SPDX-License-Identifier: BSD-3-Clause
// The detections list: one row of words per object.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <array>
#include <string>
#include <vector>

#include "console/words.hpp"

namespace mbncc::console {

struct DetectionRow {
  /// name, state, x, y, angle, score, age.
  std::array<std::string, 7> cells;
  Level level = Level::kUnknown;
  std::string reasons;  ///< why it is not confirmed, a line each
};

/// Headings of the cells.
const std::array<const char*, 7>& detection_headings();

/// Millimetres on the platform where there is a calibration, else pixels; `age` [s] of the picture.
std::vector<DetectionRow> detection_rows(const mbncc_vision::DetectedObjectArray& detections,
                                         double age);

}  // namespace mbncc::console
