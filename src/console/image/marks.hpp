// SPDX-License-Identifier: BSD-3-Clause
// Marks over an image, drawn by the window itself so that lines stay thin and text stays sharp at
// any zoom.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/LearnObjectResult.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "console/words.hpp"

namespace mbncc::console {

struct Mark {
  std::vector<std::vector<cv::Point2f>> outlines;  ///< [px] of the image, closed
  cv::Point2d origin;                              ///< [px] of the object frame
  double theta = 0;                                ///< [rad] clockwise on screen
  Level level = Level::kUnknown;
  std::string label;  ///< UTF-8, one line
};

/// One mark for each detected object.
std::vector<Mark> marks_of(const mbncc_vision::DetectedObjectArray& detections);

/// Outline and frame of a lesson's draft, with all parts and holes of its map; none without a map.
std::vector<Mark> marks_of(const mbncc_vision::LearnObjectResult& draft);

}  // namespace mbncc::console
