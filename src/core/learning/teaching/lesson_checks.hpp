// SPDX-License-Identifier: BSD-3-Clause
// Checks the input of a lesson and its map.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/learning/change.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::teaching {

/// Corners of an outline, and points of all strokes of one edit together. An outline is compared
/// with itself edge by edge.
constexpr std::size_t kMostPoints = 4096;

/// Throws LessonEnded with the code of the first fault: NAME_INVALID, NO_IMAGE, IMAGE_MISMATCH or
/// REGION_INVALID.
void check_lesson(const Lesson& lesson);

/// The lesson's region clipped to the image; the whole image when none is given. Throws
/// LessonEnded(kRegionInvalid) when less than 8 x 8 pixels remain.
cv::Rect usable_region(const Lesson& lesson);

/// "Give a point inside the image of 640 x 480 px."
std::string point_inside(const cv::Size& image);

/// False for values that are not finite or beyond the largest image size.
bool is_near_image(const cv::Point2d& point);

/// The outline filled. Throws LessonEnded(kRegionInvalid) when it crosses itself, has fewer than
/// three or more than kMostPoints corners, or lies outside.
cv::Mat outline_map(const Lesson& lesson);

/// Throws LessonEnded(kChangeTooLarge) when the camera moved between the images.
void check_camera_still(const ChangeSurvey& survey, const LearningConfig& config);

/// Throws LessonEnded(kChangeTooLarge) when the change does not tell where the object was: the
/// light was switched, or most of the scene changed.
void check_one_change(const ChangeSurvey& survey, const LearningConfig& config);

/// Throws LessonEnded if a map that the user painted is empty or full.
void check_given_map(const cv::Mat& map);

/// Throws LessonEnded(kSegmentationEmpty): nothing was cut out at the click.
[[noreturn]] void refuse_click();

/// Throws LessonEnded if the map is empty or full. `room` is the area that it could have filled.
void check_map(const cv::Mat& map, const cv::Rect& room);

}  // namespace mbncc::teaching
