// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/stamp_gate.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace mbncc {
namespace {

using Verdict = StampGate::Verdict;

TEST(StampGate, PassesImagesInOrder) {
  StampGate gate(0.5, 0.1);
  for (double stamp = 100; stamp < 102; stamp += 0.033)
    EXPECT_EQ(gate.judge(stamp, stamp + 0.02), Verdict::kFresh);
}

TEST(StampGate, DropsRepeatedAndOvertakenImages) {
  StampGate gate(0.5, 0.1);
  EXPECT_EQ(gate.judge(100, 100), Verdict::kFresh);
  EXPECT_EQ(gate.judge(100, 100.01), Verdict::kRepeated);
  EXPECT_EQ(gate.judge(99.9, 100.02), Verdict::kRepeated);
  EXPECT_EQ(gate.judge(100.03, 100.03), Verdict::kFresh);
}

TEST(StampGate, DropsOldImagesAndThoseFromTheFuture) {
  StampGate gate(0.5, 0.1);
  EXPECT_EQ(gate.judge(99.4, 100), Verdict::kLate);
  EXPECT_EQ(gate.judge(99.6, 100), Verdict::kFresh);
  EXPECT_EQ(gate.judge(100.2, 100), Verdict::kAhead);
  EXPECT_EQ(gate.judge(100.05, 100), Verdict::kFresh);
}

TEST(StampGate, ReportsABackwardClockJumpOnce) {
  StampGate gate(0.5, 0.1);
  EXPECT_EQ(gate.judge(100, 100), Verdict::kFresh);
  EXPECT_EQ(gate.judge(90, 90), Verdict::kRestarted);
  EXPECT_EQ(gate.judge(90.1, 90.1), Verdict::kFresh);
}

TEST(StampGate, ReportsTheJumpOnTheFirstUsableImage) {
  StampGate gate(0.5, 0.1);
  EXPECT_EQ(gate.judge(100, 100), Verdict::kFresh);
  EXPECT_EQ(gate.judge(100, 90), Verdict::kAhead);
  EXPECT_EQ(gate.judge(90.2, 90.2), Verdict::kRestarted);
}

TEST(StampGate, AcceptsASlewedClock) {
  StampGate gate(0.5, 0.1);
  EXPECT_EQ(gate.judge(100, 100), Verdict::kFresh);
  EXPECT_EQ(gate.judge(100.01, 99.99), Verdict::kFresh);
}

TEST(StampGate, EveryVerdictHasItsOwnWord) {
  std::set<std::string> words;
  for (const auto verdict :
       {Verdict::kFresh, Verdict::kRepeated, Verdict::kLate, Verdict::kAhead, Verdict::kRestarted})
    words.insert(to_string(verdict));
  EXPECT_EQ(words.size(), 5u);
}

TEST(StampGate, DropsAnUnstampedImage) {
  StampGate gate(0.5, 0.1);
  EXPECT_EQ(gate.judge(0, 100), Verdict::kLate);
  StampGate start(0.5, 0.1);
  EXPECT_EQ(start.judge(0, 0), Verdict::kRepeated);  // simulated time has not started
}

}  // namespace
}  // namespace mbncc
