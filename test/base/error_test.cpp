// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/error.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace mbncc::test {
namespace {

TEST(LearnErrors, EachHasAUniqueNameAndMessageAndAHint) {
  std::set<std::string> names, messages;
  int known = 0;
  for (int code = 0; code >= -99; --code) {
    const auto error = static_cast<LearnError>(code);
    if (code != -99 && std::string(to_string(error)) == "INTERNAL") continue;
    ++known;
    EXPECT_TRUE(names.insert(to_string(error)).second) << code;
    EXPECT_TRUE(messages.insert(message_of(error)).second) << code;
    EXPECT_EQ(std::string(message_of(error)).back(), '.');
    EXPECT_EQ(std::string(hint_of(error)).back(), '.');
  }
  EXPECT_EQ(known, 25);
}

TEST(FileErrors, NamePathAndReason) {
  const FileError error("/lib/wrench.png", "cut short");
  EXPECT_STREQ(error.what(), "/lib/wrench.png: cut short");
  EXPECT_EQ(error.path(), "/lib/wrench.png");
  EXPECT_EQ(error.reason(), "cut short");
}

}  // namespace
}  // namespace mbncc::test
