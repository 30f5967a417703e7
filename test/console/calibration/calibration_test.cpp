// SPDX-License-Identifier: BSD-3-Clause
// Tests with chessboards drawn as a known camera sees them.
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "console/calibration/board_calibration.hpp"
#include "console/calibration/drawn_board.hpp"
#include "console/calibration/image_check.hpp"

namespace mbncc::console {
namespace {

using Seen = BoardCalibration::Seen;

TEST(BoardCalibration, FindsTheCameraThatDrewTheBoards) {
  BoardCalibration calibration(kBoard, kImage);
  int taken = 0;
  for (int i = 0; i < 12; ++i) {
    const cv::Vec3d turn(0.4 * ((i % 3) - 1), 0.4 * ((i / 3) % 3 - 1), 0.1 * i);
    const cv::Vec3d place(-0.09 + 0.08 * ((i % 3) - 1), -0.06 + 0.05 * ((i / 3) % 3 - 1),
                          0.55 + 0.02 * i);
    taken += calibration.take(board_at(turn, place)) == Seen::kTaken;
  }
  ASSERT_GE(taken, 6);
  EXPECT_EQ(calibration.views(), static_cast<std::size_t>(taken));
  const auto result = calibration.solve();
  EXPECT_NEAR(result.info.K[0], 600, 12);
  EXPECT_NEAR(result.info.K[2], 315, 8);
  EXPECT_LT(result.error_px, 0.5);
  EXPECT_LT(result.error_mm, 0.6);
  EXPECT_EQ(result.info.width, 640u);
  EXPECT_TRUE(result.determined()) << result.focal_deviation;
}

TEST(BoardCalibration, ABoardThatWasNeverTiltedDoesNotDetermineTheFocalLength) {
  for (const double camera_tilt : {0., 0.2}) {
    const cv::Vec3d turn(camera_tilt, 0, 0);
    cv::Matx33d rotation;
    cv::Rodrigues(turn, rotation);
    BoardCalibration calibration(kBoard, kImage);
    for (int i = 0; i < 16; ++i) {
      const cv::Vec3d slid(-0.09 + 0.07 * (i % 4 - 1.5), -0.06 + 0.055 * (i / 4 - 1.5), 0);
      calibration.take(board_at(turn, rotation * slid + cv::Vec3d(0, 0, 0.6)));
    }
    ASSERT_TRUE(calibration.suffices()) << calibration.advice(Seen::kTaken);
    const auto result = calibration.solve();
    EXPECT_LT(result.error_px, 0.5) << "it fits nevertheless";
    EXPECT_FALSE(result.determined()) << result.info.K[0];
  }
}

TEST(BoardCalibration, ReportsWhereTheBoardsWere) {
  BoardCalibration calibration(kBoard, kImage);
  EXPECT_TRUE(calibration.outlines().empty());
  EXPECT_TRUE(calibration.outline().empty());
  ASSERT_EQ(calibration.take(board_at({0, 0, 0}, {-0.2, -0.15, 0.8})), Seen::kTaken);
  ASSERT_EQ(calibration.outlines().size(), 1u);
  const auto outline = calibration.outlines()[0];
  ASSERT_EQ(outline.size(), 4u);
  EXPECT_EQ(outline, calibration.outline());
  // The outline goes around the board, not across it.
  EXPECT_NEAR(cv::norm(outline[1] - outline[0]), cv::norm(outline[2] - outline[3]), 2);
  EXPECT_EQ(static_cast<int>(calibration.fields().size()), calibration.covered());
  EXPECT_EQ(calibration.fields().count(0), 0u) << "the corner of the image";
}

TEST(BoardCalibration, TheSameImageIsTakenOnce) {
  BoardCalibration calibration(kBoard, kImage);
  const cv::Mat image = board_at({0.2, 0.1, 0}, {-0.09, -0.06, 0.6});
  EXPECT_EQ(calibration.take(image), Seen::kTaken);
  EXPECT_EQ(calibration.take(image), Seen::kKnown);
  EXPECT_EQ(calibration.views(), 1u);
  EXPECT_FALSE(calibration.suffices());
  EXPECT_NE(calibration.advice(Seen::kKnown).find("not covered yet"), std::string::npos);
}

TEST(BoardCalibration, CornersOfAShrunkImageAreInCameraPixels) {
  BoardCalibration whole(kBoard, kImage), shrunk(kBoard, kImage);
  const cv::Mat image = board_at({0.2, 0.1, 0}, {-0.09, -0.06, 0.6});
  cv::Mat half;
  cv::resize(image, half, {}, 0.5, 0.5, cv::INTER_AREA);
  ASSERT_EQ(whole.take(image), Seen::kTaken);
  ASSERT_EQ(shrunk.take(half), Seen::kTaken);
  // Which end of the board comes first is not defined.
  EXPECT_LT(std::min(cv::norm(whole.corners().front() - shrunk.corners().front()),
                     cv::norm(whole.corners().front() - shrunk.corners().back())),
            1);
}

TEST(BoardCalibration, AnImageWithoutABoardIsNotTaken) {
  BoardCalibration calibration(kBoard, kImage);
  EXPECT_EQ(calibration.take(cv::Mat(kImage, CV_8UC3, cv::Scalar::all(90))), Seen::kNothing);
  EXPECT_NE(calibration.advice(Seen::kNothing).find("7 x 5"), std::string::npos);
}

TEST(ImageCheck, DistinguishesBlurredSharpSaturatedAndDarkImages) {
  const cv::Mat sharp = board_at({0.2, 0.1, 0}, {-0.09, -0.06, 0.6});
  cv::Mat blurred;
  cv::GaussianBlur(sharp, blurred, {}, 3);
  ImageCheck check;
  check.take(sharp);
  EXPECT_DOUBLE_EQ(check.sharpness(), 1);
  check.take(blurred);
  EXPECT_LT(check.sharpness(), 0.6);
  EXPECT_NE(check.advice().find("turn the focus ring back"), std::string::npos);
  check.take(cv::Mat(kImage, CV_8UC3, cv::Scalar::all(255)));
  EXPECT_NE(check.advice().find("reduce the exposure time"), std::string::npos);
  check.take(cv::Mat(kImage, CV_8UC3, cv::Scalar::all(10)));
  EXPECT_NE(check.advice().find("Too dark"), std::string::npos);
}

}  // namespace
}  // namespace mbncc::console
