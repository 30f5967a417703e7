// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terminal/progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "cli/report/stage_writer.hpp"

namespace mbncc::cli {
namespace {

TEST(Progress, ShowsTheProgressAndClearsTheLine) {
  std::ostringstream out;
  {
    Progress progress("searched", 4, out, true, 0);
    for (int i = 0; i < 4; ++i) progress.step();
    EXPECT_NE(out.str().find("searched 1 of 4"), std::string::npos);
    EXPECT_NE(out.str().find("searched 4 of 4, 0 s left"), std::string::npos);
  }
  EXPECT_EQ(out.str().substr(out.str().size() - 4), "\r\x1b[K");
}

TEST(Progress, OfOneLongItemNamesTheStep) {
  std::ostringstream out;
  Progress progress("", 1, out, true, 0);
  StageWriter stages("", {});
  const StageObserver observer = stages.observer(progress);
  EXPECT_TRUE(observer(Stage::kSegment, 0.5, "Segmenting the object.", {}));
  EXPECT_NE(out.str().find("[###############---------------] Segmenting the object., "),
            std::string::npos)
      << out.str();
  Progress to_a_file("", 1, out, false, 0);
  EXPECT_FALSE(stages.observer(to_a_file)) << "nobody would see the steps";
}

TEST(Progress, IsSilentForShortWorkAndIfNotATerminal) {
  std::ostringstream out;
  {
    Progress patient("searched", 4, out, true, 1000), to_a_file("searched", 4, out, false, 0);
    for (int i = 0; i < 4; ++i) {
      patient.step();
      to_a_file.step();
    }
  }
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace mbncc::cli
