// SPDX-License-Identifier: BSD-3-Clause
#include "console/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace mbncc::console {
namespace {

// Relative luminance of "#rrggbb" as defined by WCAG 2.
double luminance(const std::string& colour) {
  const double weights[] = {0.2126, 0.7152, 0.0722};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double value = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weights[i] * (value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
  }
  return sum;
}

TEST(Words, EveryStatusColourHasReadableContrast) {
  for (const Level level : {Level::kGood, Level::kDoubtful, Level::kBad, Level::kUnknown}) {
    const double plate = luminance(colour_of(level)), ink = luminance(ink_on(level));
    const double contrast = (std::max(plate, ink) + 0.05) / (std::min(plate, ink) + 0.05);
    EXPECT_GE(contrast, 4.5) << colour_of(level) << " under " << ink_on(level);
  }
}

// Auto is first, so that the default declares nothing.
TEST(Words, EveryDeclarableSymmetryHasAChoice) {
  std::vector<int> values;
  for (const auto& choice : symmetry_choices()) values.push_back(choice.value);
  EXPECT_EQ(values, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 255}));
}

}  // namespace
}  // namespace mbncc::console
