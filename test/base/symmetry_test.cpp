// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/symmetry.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mbncc::test {
namespace {

TEST(DeclaredSymmetry, EveryValueHasAWord) {
  const std::pair<std::optional<int>, const char*> words[] = {
      {std::nullopt, "auto"}, {1, "none"}, {2, "2"}, {3, "3"}, {5, "5"}, {12, "12"}, {0, "round"}};
  for (const auto& [symmetry, word] : words) {
    EXPECT_EQ(symmetry_text(symmetry), word);
    EXPECT_EQ(parse_symmetry(word), symmetry) << word;
    EXPECT_TRUE(is_declarable_symmetry(symmetry.value_or(1))) << word;
  }
}

TEST(DeclaredSymmetry, OtherWordsAreRefusedAndTheAllowedWordsListed) {
  for (const char* word : {"", "0", "1", "13", "02", "-2", "2.0", " 2", "Round", "twice"}) {
    try {
      parse_symmetry(word);
      ADD_FAILURE() << "'" << word << "' was taken";
    } catch (const std::invalid_argument& fault) {
      const std::string sentence = fault.what();
      EXPECT_NE(sentence.find("auto, none, 2 to 12, or round"), std::string::npos) << sentence;
    }
  }
}

TEST(DeclaredSymmetry, OtherNumbersAreRefused) {
  for (const int symmetry : {-1, 13, 255}) {
    EXPECT_FALSE(is_declarable_symmetry(symmetry)) << symmetry;
    ObjectModel model;
    EXPECT_THROW(declare_symmetry(model, symmetry), std::invalid_argument) << symmetry;
    EXPECT_FALSE(model.symmetry);
  }
}

TEST(DeclaredSymmetry, SettlesTheProposalOfTheLesson) {
  ObjectModel model;
  model.quality.reasons = {"low_texture", "nearly_symmetric_180", "small_object"};
  model.quality.advice = {"a", "b", "c"};
  declare_symmetry(model, std::nullopt);
  EXPECT_EQ(model.quality.reasons.size(), 3u) << "nothing was declared";
  declare_symmetry(model, 2);
  EXPECT_EQ(model.symmetry, 2);
  EXPECT_EQ(model.quality.reasons, (std::vector<std::string>{"low_texture", "small_object"}));
  EXPECT_EQ(model.quality.advice, (std::vector<std::string>{"a", "c"}));
  declare_symmetry(model, std::nullopt);
  EXPECT_FALSE(model.symmetry);
}

}  // namespace
}  // namespace mbncc::test
