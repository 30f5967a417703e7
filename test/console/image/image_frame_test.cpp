// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_frame.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

TEST(ImageFrame, FitsTheImageIntoTheMiddle) {
  ImageFrame frame;
  frame.set_sizes({640, 480}, {320, 480});
  EXPECT_DOUBLE_EQ(frame.scale(), 0.5);
  const cv::Point2d corner = frame.to_widget({-0.5, -0.5});
  EXPECT_NEAR(corner.x, 0, 1e-9);
  EXPECT_NEAR(corner.y, 120, 1e-9);
}

TEST(ImageFrame, BothMappingsAreInverse) {
  ImageFrame frame;
  frame.set_sizes({641, 479}, {333, 517});
  frame.zoom(3, {100, 200});
  for (const auto& point : {cv::Point2d(0, 0), cv::Point2d(123.25, 456.5)}) {
    const cv::Point2d back = frame.to_image(frame.to_widget(point));
    EXPECT_NEAR(back.x, point.x, 1e-9);
    EXPECT_NEAR(back.y, point.y, 1e-9);
  }
}

TEST(ImageFrame, ZoomKeepsThePointUnderTheMouse) {
  ImageFrame frame;
  frame.set_sizes({640, 480}, {640, 480});
  const cv::Point2d mouse(200, 100), before = frame.to_image(mouse);
  frame.zoom(2, mouse);
  frame.zoom(2, mouse);
  const cv::Point2d after = frame.to_image(mouse);
  EXPECT_NEAR(cv::norm(after - before), 0, 1e-9);
  EXPECT_DOUBLE_EQ(frame.scale(), 4);
}

TEST(ImageFrame, LimitsTheZoomAndResetsItForAnotherImageSize) {
  ImageFrame frame;
  frame.set_sizes({640, 480}, {640, 480});
  frame.zoom(0.1, {0, 0});
  EXPECT_DOUBLE_EQ(frame.scale(), 1);
  frame.zoom(4, {0, 0});
  frame.set_sizes({320, 240}, {640, 480});
  EXPECT_DOUBLE_EQ(frame.scale(), 2);
}

TEST(ImageFrame, AnEnlargedImageCanBeMovedToItsEdgesOnly) {
  ImageFrame frame;
  frame.set_sizes({640, 480}, {640, 480});
  frame.pan({50, 0});
  EXPECT_NEAR(frame.to_widget({-0.5, -0.5}).x, 0, 1e-9) << "the whole stays";
  frame.zoom(2, {320, 240});
  const double before = frame.to_widget({100, 100}).x;
  frame.pan({50, 0});
  EXPECT_NEAR(frame.to_widget({100, 100}).x, before + 50, 1e-9);
  frame.pan({5000, 5000});
  EXPECT_NEAR(frame.to_widget({-0.5, -0.5}).x, 0, 1e-9);
  EXPECT_NEAR(frame.to_widget({-0.5, -0.5}).y, 0, 1e-9);
}

}  // namespace
}  // namespace mbncc::console
