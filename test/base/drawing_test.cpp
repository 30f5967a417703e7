// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/drawing.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mbncc {
namespace {

Marking triangle(double x, double y) {
  Marking marking;
  marking.outlines = {{{float(x), float(y)}, {float(x + 20), float(y)}, {float(x), float(y + 20)}}};
  marking.pose = {x, y, 0};
  marking.caption = "triangle 0.93";
  return marking;
}

TEST(DrawMarkings, DoesNotChangeTheInputImage) {
  const cv::Mat image(100, 120, CV_8UC3, cv::Scalar::all(30)), before = image.clone();
  const cv::Mat drawn = draw_markings(image, {triangle(40, 50)});
  EXPECT_EQ(cv::norm(image, before, cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(image, drawn, cv::NORM_INF), 0);
}

TEST(DrawMarkings, DrawsXRedAndYGreenDownwards) {
  const cv::Mat drawn =
      draw_markings(cv::Mat::zeros(200, 200, CV_8UC3), {{{}, {100, 100, 0}, {}, ""}});
  const auto x = drawn.at<cv::Vec3b>(100, 120), y = drawn.at<cv::Vec3b>(120, 100);
  EXPECT_GT(x[2], 2 * x[1]);
  EXPECT_GT(y[1], 2 * y[2]);
  EXPECT_EQ(drawn.at<cv::Vec3b>(100, 80), cv::Vec3b(0, 0, 0));
}

TEST(DrawMarkings, AcceptsGreyImagesAndRefusesOtherTypes) {
  EXPECT_EQ(draw_markings(cv::Mat::zeros(50, 50, CV_8UC1), {triangle(5, 5)}).type(), CV_8UC3);
  EXPECT_THROW(draw_markings(cv::Mat::zeros(50, 50, CV_16UC1), {}), std::invalid_argument);
  EXPECT_THROW(draw_markings(cv::Mat(), {}), std::invalid_argument);
}

TEST(DrawMarkings, HandlesMarksOutsideTheImageAndTinyImages) {
  for (const double far : {-1e9, -50.0, 60.0, 1e9})
    EXPECT_NO_THROW(draw_markings(cv::Mat::zeros(16, 16, CV_8UC3), {triangle(far, far)}));
}

TEST(DrawMarkings, ShowsTheEndOfALongCaption) {
  const cv::Mat image(200, 300, CV_8UC3, cv::Scalar::all(90));
  Marking marking;
  marking.pose = {150, 100, 0};
  marking.caption = std::string(64, 'w') + " MARGINAL";
  const cv::Mat bad = draw_markings(image, {marking});
  marking.caption = std::string(64, 'w') + " GOOD";
  EXPECT_GT(cv::norm(bad, draw_markings(image, {marking}), cv::NORM_INF), 0);
}

TEST(MarkingOfView, LiesAtTheLearningPose) {
  View view;
  view.map = cv::Mat::zeros(40, 40, CV_8UC1);
  view.map(cv::Rect(10, 12, 11, 9)).setTo(255);
  view.origin = {100, 200};
  view.image_size = {640, 480};
  view.reference = {115, 216, 0.3};
  const Marking marking = marking_of(view, {}, "plate");
  ASSERT_EQ(marking.outlines.size(), 1u);
  const cv::Rect2f box = cv::Rect2f({110, 212}, cv::Size2f(10, 8));
  for (const auto& point : marking.outlines.front()) {
    EXPECT_GE(point.x, box.x - 1e-3);
    EXPECT_LE(point.x, box.br().x + 1e-3);
    EXPECT_GE(point.y, box.y - 1e-3);
    EXPECT_LE(point.y, box.br().y + 1e-3);
  }
}

}  // namespace
}  // namespace mbncc
