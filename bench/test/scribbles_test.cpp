// SPDX-License-Identifier: BSD-3-Clause
#include "learning/scribbles.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc::bench {
namespace {

const cv::Rect kRegion{60, 60, 200, 160};

class Scribbles : public ::testing::TestWithParam<cv::Size> {
 protected:
  Scribbles() : map_(cv::Mat::zeros(300, 320, CV_8UC1)) {
    cv::rectangle(map_, {{100, 90}, GetParam()}, 255, cv::FILLED);
    labels_ = scribbled(map_, kRegion);
  }
  int count_in(cv::GrabCutClasses label, const cv::Mat& area) const {
    return cv::countNonZero((labels_ == label) & area);
  }
  cv::Mat map_, labels_;
};

TEST_P(Scribbles, MarkTheObjectInsideAlone) {
  EXPECT_GT(count_in(cv::GC_FGD, map_), cv::countNonZero(map_) / 10);
  EXPECT_EQ(count_in(cv::GC_FGD, ~map_), 0);
}

TEST_P(Scribbles, MarkBackgroundOutsideAlone) {
  EXPECT_EQ(count_in(cv::GC_BGD, map_), 0);
  cv::Mat within = cv::Mat::zeros(map_.size(), CV_8UC1);
  within(kRegion).setTo(255);
  EXPECT_GT(count_in(cv::GC_BGD, within), 0);
  EXPECT_EQ(count_in(cv::GC_BGD, ~within), cv::countNonZero(~within));
}

INSTANTIATE_TEST_SUITE_P(SquareBarAndWire, Scribbles,
                         ::testing::Values(cv::Size(90, 90), cv::Size(120, 20), cv::Size(120, 3)));

}  // namespace
}  // namespace mbncc::bench
