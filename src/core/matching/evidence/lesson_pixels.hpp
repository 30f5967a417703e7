// SPDX-License-Identifier: BSD-3-Clause
// The lesson's pixels around an object, also read from an image in which it lies at a pose.
#pragma once

#include <opencv2/core.hpp>

#include "matching/scene/scene_level.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

/// Part of the lesson within the bounding box of the object's map.
struct LessonCrop {
  LessonCrop() = default;

  /// `lesson` shows the view's crop and is at least as large as `map` (CV_8UC1). `anchor` [px] is a
  /// position in it, and `rim` [px] the width of the part along the outline that `inside` lacks.
  LessonCrop(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d anchor, int rim);

  cv::Rect box;        ///< in the lesson
  cv::Mat colour;      ///< CV_8UC3
  cv::Mat inside;      ///< CV_8UC1, 255 inside the outline except for the rim
  int area = 0;        ///< [px] of `inside`
  cv::Point2d anchor;  ///< in the crop
  double reach = 0;    ///< [px] largest distance of the crop's corners from the anchor
};

class LessonPixels {
 public:
  /// The anchor lies at `pose` in an image of size `image`, the object `scale` times as large.
  LessonPixels(const LessonCrop& lesson, cv::Size image, const Pose2D& pose, double scale);

  /// `image` at the lesson's pixels, with this interpolation of OpenCV; 0 outside the image.
  cv::Mat read(const cv::Mat& image, int interpolation) const;

  /// CV_8UC1: 255 at the pixels inside the image.
  cv::Mat inside() const;

 private:
  cv::Mat warped(const cv::Mat& crop, int interpolation) const;

  cv::Size lesson_;
  cv::Rect box_;  // of the lesson in the image
  cv::Matx23d into_box_;
};

}  // namespace mbncc::evidence
