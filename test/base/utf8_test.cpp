// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/utf8.hpp"

#include <gtest/gtest.h>

#include "mbncc/label.hpp"

namespace mbncc {
namespace {

std::string encoded(unsigned code) {
  const auto rest = [code](int shift) {
    return static_cast<char>(0x80 | ((code >> shift) & 0x3f));
  };
  const auto first = [code](int mark, int shift) {
    return static_cast<char>(mark | code >> shift);
  };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {first(0xc0, 6), rest(0)};
  if (code < 0x10000) return {first(0xe0, 12), rest(6), rest(0)};
  return {first(0xf0, 18), rest(12), rest(6), rest(0)};
}

TEST(Utf8, AcceptsEveryCharacterExceptSurrogates) {
  for (unsigned code = 0; code < 0x110000; ++code) {
    const std::string text = encoded(code);
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    ASSERT_EQ(utf8_length(text + "x"), surrogate ? 0 : text.size()) << std::hex << code;
  }
  EXPECT_EQ(utf8_length(encoded(0x110000)), 0u);
}

TEST(Utf8, RefusesTruncatedOverlongAndMisalignedText) {
  for (const unsigned code : {0xe9u, 0x20acu, 0x1f527u}) {
    const std::string text = encoded(code);
    for (std::size_t length = 0; length < text.size(); ++length)
      EXPECT_EQ(utf8_length(text.substr(0, length)), 0u);
    EXPECT_EQ(utf8_length(text.substr(1)), 0u);
    EXPECT_EQ(utf8_length(text.substr(0, text.size() - 1) + "a"), 0u);
  }
  for (const char* overlong : {"\xc0\xaf", "\xc1\xbf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf"})
    EXPECT_EQ(utf8_length(overlong), 0u);
}

TEST(Label, IsPrintableUtf8OfAtMost200Bytes) {
  EXPECT_TRUE(is_valid_label(""));
  EXPECT_TRUE(is_valid_label("Schl\xc3\xbcssel 13 \xf0\x9f\x94\xa7"));
  EXPECT_TRUE(is_valid_label(std::string(200, 'a')));
  EXPECT_FALSE(is_valid_label(std::string(201, 'a')));
  for (const char* text : {"a\nb", "\x7f", "a\xff", "a\xc3"}) EXPECT_FALSE(is_valid_label(text));
}

}  // namespace
}  // namespace mbncc
