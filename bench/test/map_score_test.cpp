// SPDX-License-Identifier: BSD-3-Clause
#include "learning/map_score.hpp"

#include <gtest/gtest.h>

namespace mbncc::bench {
namespace {

cv::Mat box(int x, int y, int width, int height) {
  cv::Mat map = cv::Mat::zeros(240, 320, CV_8UC1);
  map(cv::Rect(x, y, width, height)).setTo(255);
  return map;
}

TEST(ScoreMap, EqualMapsScoreOne) {
  const MapScore score = score_map(box(80, 60, 120, 100), box(80, 60, 120, 100));
  EXPECT_DOUBLE_EQ(score.iou, 1);
  EXPECT_DOUBLE_EQ(score.boundary_f, 1);
  EXPECT_DOUBLE_EQ(score.accuracy, 1);
}

TEST(ScoreMap, CountsPixelsOfAShiftedMap) {
  const MapScore score = score_map(box(81, 60, 120, 100), box(80, 60, 120, 100));
  EXPECT_DOUBLE_EQ(score.iou, 11900.0 / 12100);
  EXPECT_DOUBLE_EQ(score.accuracy, 1 - 200.0 / 12000);
  EXPECT_DOUBLE_EQ(score.boundary_f, 1);
}

TEST(ScoreMap, BoundaryBeyondTheToleranceDoesNotCount) {
  EXPECT_LT(score_map(box(83, 60, 120, 100), box(80, 60, 120, 100)).boundary_f, 0.6);
}

TEST(ScoreMap, EmptyMapScoresNothing) {
  const MapScore score = score_map(cv::Mat::zeros(240, 320, CV_8UC1), box(80, 60, 120, 100));
  EXPECT_EQ(score.iou, 0);
  EXPECT_EQ(score.boundary_f, 0);
  EXPECT_EQ(score.accuracy, 0);
}

}  // namespace
}  // namespace mbncc::bench
