// SPDX-License-Identifier: BSD-3-Clause
// A correction of a lesson by the operator.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc {

/// One correction, as in srv/ConfirmLearning.srv. Fields that are not set change nothing.
struct LessonEdit {
  using Line = std::vector<cv::Point2f>;  ///< [px] in the learning image

  std::vector<Line> include;        ///< belongs to the object
  std::vector<Line> exclude;        ///< belongs to the background; overrides `include`
  double stroke_width = 0;          ///< [px] width of the lines, at most 1000; 0: filled areas
  cv::Rect region;                  ///< [px] new approximate region; empty: as before
  std::optional<Pose2D> reference;  ///< [px],[rad] object frame
};

}  // namespace mbncc
