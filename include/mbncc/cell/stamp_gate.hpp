// SPDX-License-Identifier: BSD-3-Clause
// Decides by their stamps which images may be searched: each once, in order, neither old nor from
// the future. Fails closed: a stale image would move an arm to an old position.
#pragma once

namespace mbncc {

class StampGate {
 public:
  enum class Verdict {
    kFresh,
    kRepeated,  ///< not newer than the last fresh one
    kLate,      ///< older than max_age
    kAhead,     ///< stamped more than max_ahead in the future
    kRestarted  ///< fresh, and the clock has jumped back: drop all earlier results
  };

  /// `max_age` and `max_ahead` [s].
  StampGate(double max_age, double max_ahead) : max_age_(max_age), max_ahead_(max_ahead) {}

  /// Classifies an image stamped `stamp` that arrives at `now` [s].
  Verdict judge(double stamp, double now);

 private:
  double max_age_;
  double max_ahead_;
  double last_stamp_ = 0;
  double last_now_ = 0;
  bool restarted_ = false;
};

/// Word for diagnostics: "fresh", "repeated", "late", "ahead" or "restarted".
const char* to_string(StampGate::Verdict verdict);

}  // namespace mbncc
