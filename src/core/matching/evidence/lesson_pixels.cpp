// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/lesson_pixels.hpp"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"

namespace mbncc::evidence {

LessonPixels::LessonPixels(cv::Size lesson, cv::Point2d anchor, cv::Size image, const Pose2D& pose,
                           double scale)
    : lesson_(lesson) {
  constexpr int kSlack = 2;  // [px] for the interpolation
  const Transform placed(pose);
  std::vector<cv::Point2f> corners;
  for (const int x : {0, lesson.width})
    for (const int y : {0, lesson.height})
      corners.emplace_back(placed(scale * (cv::Point2d(x, y) - anchor)));
  box_ = imaging::grown(cv::boundingRect(corners), kSlack) & cv::Rect({0, 0}, image);
  const cv::Point2d first = placed(-scale * anchor) - cv::Point2d(box_.tl());
  const cv::Point2d right = rotate({scale, 0}, pose.theta), down = rotate({0, scale}, pose.theta);
  into_box_ = {right.x, down.x, first.x, right.y, down.y, first.y};
}

cv::Mat LessonPixels::read(const cv::Mat& image, int interpolation) const {
  return box_.empty() ? cv::Mat::zeros(lesson_, image.type()) : warped(image(box_), interpolation);
}

cv::Mat LessonPixels::inside() const {
  return box_.empty() ? cv::Mat::zeros(lesson_, CV_8UC1)
                      : warped(cv::Mat(box_.size(), CV_8UC1, cv::Scalar(255)), cv::INTER_NEAREST);
}

cv::Mat LessonPixels::warped(const cv::Mat& crop, int interpolation) const {
  cv::Mat result;
  cv::warpAffine(crop, result, into_box_, lesson_, interpolation | cv::WARP_INVERSE_MAP);
  return result;
}

}  // namespace mbncc::evidence
