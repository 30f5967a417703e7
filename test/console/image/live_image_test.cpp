// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/live_image.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

constexpr bool kSearched = true, kBare = false, kTeaching = true;

TEST(LiveImage, ShowsDetections) {
  LiveImage live;
  EXPECT_TRUE(live.take(kSearched, !kTeaching, 10));
  EXPECT_FALSE(live.take(kBare, !kTeaching, 10.1));
}

TEST(LiveImage, ShowsBareImagesDuringALesson) {
  LiveImage live;
  EXPECT_TRUE(live.take(kBare, kTeaching, 10));
  EXPECT_FALSE(live.take(kSearched, kTeaching, 10.1));
}

TEST(LiveImage, ShowsBareImagesWhereNothingIsSearched) {
  LiveImage live;
  EXPECT_TRUE(live.take(kBare, !kTeaching, 10)) << "nothing was ever searched";
  EXPECT_TRUE(live.take(kSearched, !kTeaching, 11));
  EXPECT_FALSE(live.take(kBare, !kTeaching, 11.9)) << "the matcher may be slow";
  EXPECT_TRUE(live.take(kBare, !kTeaching, 12.1)) << "the matcher is gone, its last image old";
  EXPECT_TRUE(live.take(kSearched, !kTeaching, 12.2));
  EXPECT_FALSE(live.take(kBare, !kTeaching, 12.3)) << "and is back";
}

TEST(LiveImage, AgeIsThatOfTheImageShown) {
  LiveImage live(5);
  EXPECT_EQ(live.age(7), 2);
  live.take(kSearched, !kTeaching, 10);
  live.take(kBare, !kTeaching, 10.5);
  EXPECT_EQ(live.age(11), 1);
}

}  // namespace
}  // namespace mbncc::console
