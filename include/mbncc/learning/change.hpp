// What changed between two pictures of a still camera, seen coarsely: where to look closer, and
// whether the pictures can be compared at all.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

struct ChangeSurvey {
  cv::Mat changed;      ///< CV_8UC1 of the pictures' size, 255 where they differ beyond noise
  double fraction = 0;  ///< [0..1] changed part of the picture
  double gain = 1;      ///< exposure of `before` relative to `after`
};

/// Compares two CV_8UC3 pictures of one size at about 320 pixels width: the exposure of each
/// channel is evened out, a camera shift of a pixel or so is forgiven.
ChangeSurvey survey_change(const cv::Mat& before, const cv::Mat& after);

/// Bounding box, with a margin, of the largest group of changed pixels; empty when nothing changed.
cv::Rect changed_region(const ChangeSurvey& survey);

}  // namespace mbncc
