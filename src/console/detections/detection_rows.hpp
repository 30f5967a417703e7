// SPDX-License-Identifier: BSD-3-Clause
// The list of detections: one row of text per object.
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
  std::string reasons;  ///< why the object is not confirmed, one reason per line
};

/// Headings of the columns.
const std::array<const char*, 7>& detection_headings();

/// Positions are in millimetres on the platform if the camera is calibrated, otherwise in pixels;
/// `age` [s] of the image.
std::vector<DetectionRow> detection_rows(const mbncc_vision::DetectedObjectArray& detections,
                                         double age);

}  // namespace mbncc::console
