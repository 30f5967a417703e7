// SPDX-License-Identifier: BSD-3-Clause
// `mbncc learn --overwrite` is killed at random moments: either the old object or the new one
// remains.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "cli/tool.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/kills.hpp"

namespace mbncc::test {
namespace {

using Clock = std::chrono::steady_clock;

// The delay before each kill is what this test varies; it does not wait for anything.
TEST(KilledLearn, LeavesTheOldObjectOrTheNewOne) {
  const int kills = kills_wanted(30);
  const LessonFolder folder;
  const auto words = folder.lesson("part") + std::vector<std::string>{"--overwrite"};
  ASSERT_EQ(run_tool(words).code, 0);
  const auto start = Clock::now();
  ASSERT_EQ(run_tool(words).code, 0);
  const std::chrono::duration<double> whole = Clock::now() - start;

  std::mt19937 random(17);
  // Half of the kills happen at any time, half near the end, when the file is written.
  std::uniform_real_distribution<double> anywhere(0, 1), near_end(0.7, 1);
  ObjectLibrary library(folder.library());
  std::uint32_t revision = 1;
  int stored = 0, killed = 0;
  for (int i = 0; i < kills; ++i) {
    const pid_t child = start_tool(words, "/dev/null", "/dev/null");
    std::this_thread::sleep_for(whole * (i % 2 == 0 ? anywhere(random) : near_end(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    killed += WIFSIGNALED(status) ? 1 : 0;
    const auto snapshot = library.load();
    ASSERT_TRUE(snapshot->quarantined.empty());
    const auto object = snapshot->find("part");
    ASSERT_NE(object, nullptr);
    ASSERT_GE(object->revision, revision);
    stored += object->revision > revision ? 1 : 0;
    revision = object->revision;
  }
  RecordProperty("killed", killed);
  RecordProperty("new_revision", stored);
  std::printf("%d of %d runs killed, %d left a new revision\n", killed, kills, stored);
  ASSERT_EQ(run_tool(words).code, 0) << "and the library still takes lessons";
}

}  // namespace
}  // namespace mbncc::test
