// SPDX-License-Identifier: BSD-3-Clause
// The lesson's pixels, read from an image in which the object lies at a pose.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

class LessonPixels {
 public:
  /// `lesson` [px]: size of the lesson's crop, in which the object's anchor lies at `anchor`. The
  /// anchor lies at `pose` in an image of size `image`, the object `scale` times as large.
  LessonPixels(cv::Size lesson, cv::Point2d anchor, cv::Size image, const Pose2D& pose,
               double scale);

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
