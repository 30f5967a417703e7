// SPDX-License-Identifier: BSD-3-Clause
// A sentence beside the lesson's own, such as the library's refusal. The lesson speaks several
// times a second, so what is said in between would be gone before anybody has read it.
#pragma once

#include <string>

#include "console/words.hpp"

namespace mbncc::console {

class Notice {
 public:
  /// How long it stays. [s]
  static constexpr double kStays = 6;

  struct Line {
    Level level = Level::kUnknown;
    std::string text;
  };

  /// Takes the place of what was posted before.
  void post(const Line& line, double now);
  /// What was said is out of date.
  void clear() { until_ = -1; }
  /// What to show while the lesson says `lesson`.
  const Line& over(const Line& lesson, double now) const;

 private:
  Line line_;
  double until_ = -1;
};

}  // namespace mbncc::console
