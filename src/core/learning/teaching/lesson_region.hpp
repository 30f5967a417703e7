// SPDX-License-Identifier: BSD-3-Clause
// Determines the region of a lesson's object from the lesson's input and its images.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::teaching {

/// All maps are CV_8UC1 of the image's size, 0/255.
struct RegionOfLesson {
  cv::Rect room;                ///< [px] the object lies in here
  cv::Mat approximate;          ///< the paper's approximate region
  cv::Mat changed;              ///< where something may have left; empty without an image after
  cv::Mat surveyed;             ///< all changes, arrivals included; likewise
  double agreement = 1;         ///< of a click in one image, as in ClickedRegion
  double second_departure = 0;  ///< as in CutEvidence
};

/// No place is given, so the largest departure is the object.
bool is_without_place(const Lesson& lesson);

/// For a lesson that passed check_lesson(). Throws LessonEnded: kRegionInvalid, kChangeTooLarge for
/// images that cannot be compared, kNoChange when nothing was taken away there,
/// kSegmentationEmpty when a click in one image shows no object.
RegionOfLesson region_of(const Lesson& lesson, const LearningConfig& config);

}  // namespace mbncc::teaching
