// SPDX-License-Identifier: BSD-3-Clause
#include "console/notice.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

const Notice::Line kLesson{Level::kUnknown, "Take the object away now."};

TEST(Notice, WithoutANoticeTheLessonTextIsShown) {
  const Notice notice;
  EXPECT_EQ(notice.over(kLesson, 0).text, kLesson.text);
}

TEST(Notice, StaysVisibleForItsFullTime) {
  Notice notice;
  notice.post({Level::kBad, "Library: the name is taken"}, 10);
  const Notice::Line shown = notice.over(kLesson, 10.2);
  EXPECT_EQ(shown.text, "Library: the name is taken");
  EXPECT_EQ(shown.level, Level::kBad);
  EXPECT_EQ(notice.over({}, 10 + Notice::kStays - 0.1).level, Level::kBad);
  EXPECT_EQ(notice.over(kLesson, 10 + Notice::kStays).text, kLesson.text);
}

TEST(Notice, TheNewestNoticeIsShown) {
  Notice notice;
  notice.post({Level::kBad, "first"}, 10);
  notice.post({Level::kGood, "second"}, 11);
  EXPECT_EQ(notice.over(kLesson, 12).text, "second");
}

TEST(Notice, AClearedNoticeIsNotShown) {
  Notice notice;
  notice.post({Level::kBad, "Library: the name is taken"}, 10);
  notice.clear();
  EXPECT_EQ(notice.over(kLesson, 10.1).text, kLesson.text);
}

}  // namespace
}  // namespace mbncc::console
