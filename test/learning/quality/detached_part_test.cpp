// SPDX-License-Identifier: BSD-3-Clause
#include "learning/quality/detached_part.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc::quality {
namespace {

/// A map with a square of 100 px at (100, 100), 10,000 px in area.
class DetachedPartTest : public testing::Test {
 protected:
  DetachedPartTest() : map_(cv::Mat::zeros(400, 500, CV_8UC1)) { fill({100, 100, 100, 100}); }
  void fill(const cv::Rect& part) { map_(part).setTo(255); }

  cv::Mat map_;
};

TEST_F(DetachedPartTest, OnePartIsWhole) {
  EXPECT_FALSE(detached_part(map_));
}

TEST_F(DetachedPartTest, AFarSpeckIsFound) {
  fill({400, 300, 3, 3});
  const auto part = detached_part(map_);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->area, 9);
  EXPECT_EQ(part->centre, cv::Point(401, 301));
}

TEST_F(DetachedPartTest, ASpeckBesideTheObjectHardlyMatters) {
  fill({202, 150, 3, 3});
  EXPECT_FALSE(detached_part(map_));
}

TEST_F(DetachedPartTest, ASecondPartOfTheObjectStays) {
  fill({300, 100, 20, 26});  // .049 of both
  EXPECT_TRUE(detached_part(map_));
  fill({300, 100, 20, 27});  // .051
  EXPECT_FALSE(detached_part(map_));
}

TEST_F(DetachedPartTest, TheCircleMayGrowByATenth) {
  // The square's circle has a radius of 70 px.
  fill({235, 149, 1, 1});  // 1.094 times as large
  EXPECT_FALSE(detached_part(map_));
  fill({240, 149, 1, 1});  // 1.125
  const auto part = detached_part(map_);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->centre, cv::Point(240, 149)) << "the farthest of both";
}

TEST_F(DetachedPartTest, AnObjectOfManyEqualPartsIsWhole) {
  map_.setTo(0);
  for (int x = 0; x < 450; x += 15)
    for (int y = 0; y < 390; y += 15) fill({x, y, 5, 5});
  EXPECT_FALSE(detached_part(map_));
}

}  // namespace
}  // namespace mbncc::quality
