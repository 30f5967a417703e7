// SPDX-License-Identifier: BSD-3-Clause
// Determines the region of a lesson's object from the lesson's input and its images.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/lesson.hpp"

namespace mbncc::teaching {

/// All maps are CV_8UC1 of the image's size, 0/255.
struct RegionOfLesson {
  cv::Rect room;                ///< [px] the object lies in here
  cv::Mat approximate;          ///< the paper's approximate region
  cv::Mat changed;              ///< where something may have left; empty without an image after
  cv::Mat surveyed;             ///< all changes, arrivals included; empty without an image after
  double agreement = 1;         ///< for a click in one image, as in ClickedRegion; otherwise 1
  double second_departure = 0;  ///< as in CutEvidence
};

/// Whether no place is given, so that the largest departure is the object.
inline bool is_without_place(const Lesson& lesson) {
  return lesson.region == cv::Rect() && !lesson.click;
}

/// The lesson's region clipped to the image; the whole image when none is given. Throws
/// LessonEnded(kRegionInvalid) when less than 8 x 8 pixels remain.
cv::Rect usable_region(const Lesson& lesson);

/// The outline filled. Throws LessonEnded(kRegionInvalid) when it crosses itself, has fewer than
/// three or more than kMostPoints corners, or lies outside.
cv::Mat outline_map(const Lesson& lesson);

/// Throws LessonEnded(kChangeTooLarge) when the camera moved between the images.
void check_camera_still(const ChangeSurvey& survey, const LearningConfig& config);

/// Throws LessonEnded(kChangeTooLarge) when the change does not tell where the object was: the
/// light was switched, or most of the scene changed.
void check_one_change(const ChangeSurvey& survey, const LearningConfig& config);

/// For a lesson that passed check_lesson(). Throws LessonEnded: kRegionInvalid, kChangeTooLarge for
/// images that cannot be compared, kNoChange when nothing was taken away there,
/// kSegmentationEmpty when a click in one image shows no object.
RegionOfLesson region_of(const Lesson& lesson, const LearningConfig& config);

}  // namespace mbncc::teaching
