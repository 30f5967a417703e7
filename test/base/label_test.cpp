// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/label.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

TEST(Label, TextsOfAnyLanguageArePrintable) {
  for (const char* text :
       {"", "wrench 10 mm", "M\xc3\xbcller", "\xd7\x9e\xd7\xa4\xd7\xaa\xd7\x97",
        "\xe6\x89\xb3\xe6\x89\x8b", "\xf0\x9f\x94\xa7", "\xc2\xa0", "\xe2\x80\x93"})
    EXPECT_TRUE(is_printable(text)) << text;
}

TEST(Label, ControlCharactersAreNotPrintable) {
  const std::string texts[] = {
      "a\n",          "\t",           "\x1b[31m",     std::string("a\0b", 3),
      "\x7f",         "\xc2\x80",     "\xc2\x9b",     "\xc2\x9f",
      "\xd8\x9c",     "\xe2\x80\x8e", "\xe2\x80\x8f", "\xe2\x80\xa8",
      "\xe2\x80\xa9", "\xe2\x80\xaa", "\xe2\x80\xae", "\xe2\x81\xa6",
      "\xe2\x81\xa9", "\xff",         "\xc0\x80",     "a\xe2\x80"};
  for (const auto& text : texts) {
    EXPECT_FALSE(is_printable(text)) << ::testing::PrintToString(text);
    EXPECT_FALSE(is_valid_label("label " + text)) << ::testing::PrintToString(text);
  }
}

TEST(Label, LabelsHave200BytesAtMost) {
  EXPECT_TRUE(is_valid_label(std::string(200, 'x')));
  EXPECT_FALSE(is_valid_label(std::string(201, 'x')));
  EXPECT_TRUE(is_printable(std::string(201, 'x')));
}

}  // namespace
}  // namespace mbncc
