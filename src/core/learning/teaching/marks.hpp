// SPDX-License-Identifier: BSD-3-Clause
// The operator's strokes on the learning image.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/learning/lesson_edit.hpp"

namespace mbncc::teaching {

/// CV_8UC1 of the image's size, 255 where painted; they do not overlap. Both empty: no marks.
struct Marks {
  cv::Mat include;
  cv::Mat exclude;

  bool empty() const { return include.empty(); }
};

/// `marks` with the strokes of `edit` painted over them; `marks` itself is not changed. Throws
/// LessonEnded(kRegionInvalid) for strokes with points that are not finite, or outside the image.
Marks painted(const Marks& marks, const LessonEdit& edit, const cv::Size& image);

/// `map` with the strokes painted into it.
cv::Mat overpainted(const cv::Mat& map, const Marks& marks);

}  // namespace mbncc::teaching
