// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/rate_limit.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

/// Number of images that pass in 100 s if they arrive at `camera` [Hz], each early or late by up to
/// `jitter` of a period.
int passed(double camera, double limit, double jitter = 0) {
  RateLimit rate;
  int count = 0;
  for (int i = 0; i < 100 * camera; ++i) {
    const double stamp = 1e9 + (i + jitter * ((i * 7 % 11) / 5. - 1)) / camera;
    if (!rate.allows(stamp, limit)) continue;
    rate.note(stamp, limit);
    ++count;
  }
  return count;
}

TEST(RateLimit, IsReachedAndNotExceeded) {
  for (const double limit : {1., 7., 10., 20., 29., 30.}) {
    EXPECT_NEAR(passed(30, limit), 100 * limit, 2) << limit;
    EXPECT_NEAR(passed(30, limit, 0.2), 100 * limit, 2) << limit;
  }
  EXPECT_EQ(passed(30, 60), 3000) << "no more than there are";
  EXPECT_EQ(passed(30, 0), 3000) << "0: no limit";
}

TEST(RateLimit, APauseDoesNotAllowABurst) {
  RateLimit rate;
  rate.note(1, 10);
  int count = 0;
  for (int i = 0; i < 10; ++i) {  // ten images within a tenth of a second, after a long pause
    if (!rate.allows(100 + i / 100., 10)) continue;
    rate.note(100 + i / 100., 10);
    ++count;
  }
  EXPECT_LE(count, 3);
}

TEST(RateLimit, ImagesThatWereNotSearchedDoNotCount) {
  RateLimit rate;
  rate.note(1, 1);
  EXPECT_FALSE(rate.allows(1.2, 1));
  EXPECT_TRUE(rate.allows(2, 1));
  EXPECT_TRUE(rate.allows(2.1, 1)) << "until one is noted";
}

TEST(RateLimit, RestartsAfterAReset) {
  RateLimit rate;
  rate.note(100, 1);
  EXPECT_FALSE(rate.allows(1, 1));
  rate.reset();
  EXPECT_TRUE(rate.allows(1, 1));
}

}  // namespace
}  // namespace mbncc
