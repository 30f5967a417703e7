// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/stamp_gate.hpp"

#include <utility>

namespace mbncc {
namespace {

// Clocks are slewed by some milliseconds; a restarted bag jumps back by more.
constexpr double kJump = 0.05;  // [s]

}  // namespace

StampGate::Verdict StampGate::judge(double stamp, double now) {
  if (now < last_now_ - kJump) {
    restarted_ = true;
    last_stamp_ = 0;
  }
  last_now_ = now;
  if (now - stamp > max_age_) return Verdict::kLate;
  if (stamp - now > max_ahead_) return Verdict::kAhead;
  if (stamp <= last_stamp_) return Verdict::kRepeated;
  last_stamp_ = stamp;
  return std::exchange(restarted_, false) ? Verdict::kRestarted : Verdict::kFresh;
}

const char* to_string(StampGate::Verdict verdict) {
  switch (verdict) {
    case StampGate::Verdict::kFresh:
      return "fresh";
    case StampGate::Verdict::kRepeated:
      return "repeated";
    case StampGate::Verdict::kLate:
      return "late";
    case StampGate::Verdict::kAhead:
      return "ahead";
    case StampGate::Verdict::kRestarted:
      return "restarted";
  }
  return "";
}

}  // namespace mbncc
