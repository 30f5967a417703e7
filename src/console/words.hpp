// SPDX-License-Identifier: BSD-3-Clause
// The console's texts for stages, verdicts and states, each with a symbol, so that no meaning
// depends on colour alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mbncc::console {

enum class Level { kGood, kDoubtful, kBad, kUnknown };

/// UTF-8: a tick, an exclamation mark, a cross, a question mark.
const char* symbol_of(Level level);

/// "#rrggbb" of a background, from Okabe and Ito's palette: blue, orange, vermilion, grey.
const char* colour_of(Level level);

/// "#rrggbb" of a line over an image: a lighter colour_of().
const char* bright_colour_of(Level level);

/// "#rrggbb" of text on that background, with a contrast ratio of at least 4.5 (WCAG 2, AA).
const char* ink_on(Level level);

/// The operator's task in a stage of LearnObjectFeedback, in a few words.
std::string headline_of(std::uint8_t stage);

/// Level of LearnQuality::verdict.
Level level_of_verdict(std::uint8_t verdict);
std::string word_of_verdict(std::uint8_t verdict);

/// Level of DetectedObject::state.
Level level_of_state(std::uint8_t state);
std::string word_of_state(std::uint8_t state);

/// Symmetries to declare: values of LearnObjectGoal::symmetry with texts, auto first.
struct SymmetryChoice {
  std::uint8_t value;
  std::string text;
};
std::vector<SymmetryChoice> symmetry_choices();

/// "1:05 left", "" below 0.
std::string time_left(double seconds);

}  // namespace mbncc::console
