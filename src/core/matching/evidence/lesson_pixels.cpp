// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/lesson_pixels.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"

namespace mbncc::evidence {

namespace {

std::vector<cv::Point2d> corners_of(cv::Size size) {
  return {{0., 0.},
          {0., static_cast<double>(size.height)},
          {static_cast<double>(size.width), 0.},
          {static_cast<double>(size.width), static_cast<double>(size.height)}};
}

}  // namespace

LessonCrop::LessonCrop(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d at, int rim)
    : box(cv::boundingRect(map)),
      colour(lesson.whole().colour(box).clone()),
      anchor(at - cv::Point2d(box.tl())) {
  for (const auto& corner : corners_of(box.size()))
    reach = std::max(reach, cv::norm(corner - anchor));
  cv::erode(map(box).clone(), inside, cv::Mat::ones(2 * rim + 1, 2 * rim + 1, CV_8U), {-1, -1}, 1,
            cv::BORDER_CONSTANT, cv::Scalar(0));
  area = cv::countNonZero(inside);
}

LessonPixels::LessonPixels(const LessonCrop& lesson, cv::Size image, const Pose2D& pose,
                           double scale)
    : lesson_(lesson.colour.size()) {
  constexpr int kSlack = 2;  // [px] for the interpolation
  const Transform placed(pose);
  std::vector<cv::Point2f> corners;
  for (const auto& corner : corners_of(lesson_))
    corners.emplace_back(placed(scale * (corner - lesson.anchor)));
  box_ = imaging::grown(cv::boundingRect(corners), kSlack) & cv::Rect({0, 0}, image);
  const cv::Point2d first = placed(-scale * lesson.anchor) - cv::Point2d(box_.tl());
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
