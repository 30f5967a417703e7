// SPDX-License-Identifier: BSD-3-Clause
// Checks the input of a lesson, and whether its verdict ends it.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <string>

#include "mbncc/image_limits.hpp"
#include "mbncc/learning/lesson.hpp"

namespace mbncc::teaching {

/// Most corners of an outline, and most points of all strokes of one edit together. The limit
/// bounds the time of checking every pair of an outline's edges.
constexpr std::size_t kMostPoints = 4096;

/// Throws LessonEnded with the code of the first fault: NAME_INVALID, NO_IMAGE, IMAGE_MISMATCH or
/// REGION_INVALID.
void check_lesson(const Lesson& lesson);

/// Error code of a BAD verdict: the code of its worst reason, kQualityBad if the reason has none.
LearnError error_of(const Quality& quality);

/// False for values that are not finite or far beyond the largest image size.
inline bool is_near_image(const cv::Point2d& point) {
  constexpr double kFarthest = 2 * ImageLimits::kMostSide;
  return std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest;
}

/// "640 x 480"
inline std::string size_text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// "Give a point inside the image of 640 x 480 px."
inline std::string point_inside(const cv::Size& image) {
  return "Give a point inside the image of " + size_text(image) + " px.";
}

}  // namespace mbncc::teaching
