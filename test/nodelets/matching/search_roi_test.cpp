// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/search_roi.hpp"

#include <gtest/gtest.h>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {
namespace {

TEST(SearchRoi, ReadsFourNumbersOrNothing) {
  EXPECT_EQ(parse_roi("10,20,30,40"), cv::Rect(10, 20, 30, 40));
  EXPECT_TRUE(parse_roi("").empty());
  for (const char* text : {"10,20,30", "10,20,30,0", "-1,0,5,5", "a,b,c,d", "1,2,3,4,5"})
    EXPECT_THROW(parse_roi(text), ConfigError) << text;
}

TEST(SearchRoi, IsClippedToTheImage) {
  EXPECT_EQ(roi_in({10, 20, 30, 40}, {640, 480}), cv::Rect(10, 20, 30, 40));
  EXPECT_EQ(roi_in({600, 20, 100, 40}, {640, 480}), cv::Rect(600, 20, 40, 40));
  EXPECT_TRUE(roi_in({}, {640, 480}).empty()) << "everywhere";
}

TEST(SearchRoi, OutsideTheImageIsRefused) {
  EXPECT_THROW(roi_in({640, 0, 10, 10}, {640, 480}), ConfigError);
}

}  // namespace
}  // namespace mbncc::nodelets
