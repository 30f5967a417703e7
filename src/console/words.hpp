// SPDX-License-Identifier: BSD-3-Clause
// What the console says: stages, verdicts and states in plain words, with a symbol each, so that
// nothing depends on colour alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mbncc::console {

enum class Level { kGood, kDoubtful, kBad, kUnknown };

/// UTF-8: a tick, an exclamation mark, a cross, a question mark.
const char* symbol_of(Level level);

/// "#rrggbb" of a plate, after Okabe and Ito's palette: blue, orange, vermilion, grey.
const char* colour_of(Level level);

/// "#rrggbb" of a line over a picture: as colour_of(), lighter.
const char* bright_colour_of(Level level);

/// "#rrggbb" of what is written on that plate: at least 4.5 times as light or dark (WCAG 2, AA).
const char* ink_on(Level level);

/// What the operator has to do in a stage of LearnObjectFeedback, a few words.
std::string headline_of(std::uint8_t stage);

/// Of LearnQuality::verdict.
Level level_of_verdict(std::uint8_t verdict);
std::string word_of_verdict(std::uint8_t verdict);

/// Of DetectedObject::state.
Level level_of_state(std::uint8_t state);
std::string word_of_state(std::uint8_t state);

/// What an operator may declare: values of LearnObjectGoal::symmetry in words, auto first.
struct SymmetryChoice {
  std::uint8_t value;
  const char* text;
};
const std::vector<SymmetryChoice>& symmetry_choices();

/// "1:05 left", "" below 0.
std::string time_left(double seconds);

}  // namespace mbncc::console
