// SPDX-License-Identifier: BSD-3-Clause
#include "console/words.hpp"

#include <mbncc_vision/DetectedObject.h>
#include <mbncc_vision/LearnObjectFeedback.h>
#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnQuality.h>

#include <cmath>
#include <cstdio>

namespace mbncc::console {

using mbncc_vision::DetectedObject;
using mbncc_vision::LearnQuality;
using Feedback = mbncc_vision::LearnObjectFeedback;

const char* symbol_of(Level level) {
  switch (level) {
    case Level::kGood:
      return "\u2714";
    case Level::kDoubtful:
      return "\u26a0";
    case Level::kBad:
      return "\u2716";
    case Level::kUnknown:
      return "?";
  }
  return "?";
}

const char* colour_of(Level level) {
  switch (level) {
    case Level::kGood:
      return "#0072b2";
    case Level::kDoubtful:
      return "#e69f00";
    case Level::kBad:
      return "#c25500";
    case Level::kUnknown:
      return "#6e6e6e";
  }
  return "#6e6e6e";
}

const char* bright_colour_of(Level level) {
  switch (level) {
    case Level::kGood:
      return "#56b4e9";
    case Level::kDoubtful:
      return "#e69f00";
    case Level::kBad:
      return "#ff7f32";
    case Level::kUnknown:
      return "#e0e0e0";
  }
  return "#e0e0e0";
}

const char* ink_on(Level level) {
  return level == Level::kDoubtful ? "#000000" : "#ffffff";
}

std::string headline_of(std::uint8_t stage) {
  switch (stage) {
    case Feedback::WAIT_IMAGE:
      return "Keep the scene still";
    case Feedback::WAIT_REMOVAL:
      return "Take the object away";
    case Feedback::WAIT_STILL:
      return "Clear the image, then keep still";
    case Feedback::REGION:
      return "Finding the change";
    case Feedback::SEGMENT:
      return "Segmenting the object";
    case Feedback::QUALITY:
      return "Checking that it will be found";
    case Feedback::WAIT_CONFIRM:
      return "Is the outline right?";
    case Feedback::STORE:
      return "Storing";
    default:
      return "Working";
  }
}

Level level_of_verdict(std::uint8_t verdict) {
  if (verdict == LearnQuality::GOOD) return Level::kGood;
  return verdict == LearnQuality::MARGINAL ? Level::kDoubtful : Level::kBad;
}

std::string word_of_verdict(std::uint8_t verdict) {
  if (verdict == LearnQuality::GOOD) return "GOOD";
  return verdict == LearnQuality::MARGINAL ? "MARGINAL" : "BAD";
}

Level level_of_state(std::uint8_t state) {
  if (state == DetectedObject::CONFIRMED) return Level::kGood;
  return state == DetectedObject::AMBIGUOUS ? Level::kDoubtful : Level::kUnknown;
}

std::string word_of_state(std::uint8_t state) {
  switch (state) {
    case DetectedObject::NEW:
      return "not sure yet";
    case DetectedObject::CONFIRMED:
      return "confirmed";
    case DetectedObject::AMBIGUOUS:
      return "ambiguous";
    case DetectedObject::HELD:
      return "held";
    default:
      return "unknown";
  }
}

std::vector<SymmetryChoice> symmetry_choices() {
  using Goal = mbncc_vision::LearnObjectGoal;
  constexpr std::uint8_t kMostEqualAngles = 12;
  std::vector<SymmetryChoice> choices{{Goal::SYMMETRY_AUTO, "measured symmetry"},
                                      {Goal::SYMMETRY_NONE, "no symmetry"}};
  for (std::uint8_t angles = 2; angles <= kMostEqualAngles; ++angles) {
    char text[32];
    std::snprintf(text, sizeof text, "same after %.4g\u00b0", 360.0 / angles);
    choices.push_back({angles, text});
  }
  choices.push_back({Goal::SYMMETRY_ROUND, "round"});
  return choices;
}

std::string time_left(double seconds) {
  if (seconds < 0) return "";
  const int whole = static_cast<int>(std::lround(seconds));
  char text[32];
  std::snprintf(text, sizeof text, "%d:%02d left", whole / 60, whole % 60);
  return text;
}

}  // namespace mbncc::console
