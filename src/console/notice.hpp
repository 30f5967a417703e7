// SPDX-License-Identifier: BSD-3-Clause
// A notice that replaces the lesson's own message, such as the library's refusal. The lesson sends
// messages several times per second, so without a minimum time the notice could not be read.
#pragma once

#include <string>

#include "console/words.hpp"

namespace mbncc::console {

class Notice {
 public:
  /// How long it is shown. [s]
  static constexpr double kStays = 6;

  struct Line {
    Level level = Level::kUnknown;
    std::string text;
  };

  /// Replaces an earlier notice.
  void post(const Line& line, double now);
  /// Removes a notice that is out of date.
  void clear() { until_ = -1; }
  /// The text to show: the notice, or the lesson's message `lesson`.
  const Line& over(const Line& lesson, double now) const;

 private:
  Line line_;
  double until_ = -1;
};

}  // namespace mbncc::console
