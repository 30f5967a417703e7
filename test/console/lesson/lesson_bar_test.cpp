// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/lesson_bar.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

using Goal = mbncc_vision::LearnObjectGoal;

TEST(LessonBar, TheNextObjectHasNeitherNameNorHeightNorSymmetryOfTheLastOne) {
  LessonBar bar;
  Goal goal;
  goal.object_height = 0.03;
  goal.symmetry = Goal::SYMMETRY_2;
  bar.set_name("part");
  bar.show_goal(goal);
  EXPECT_EQ(bar.goal().name, "part");
  EXPECT_DOUBLE_EQ(bar.goal().object_height, 0.03);
  EXPECT_EQ(bar.goal().symmetry, Goal::SYMMETRY_2);
  bar.clear_object();
  EXPECT_EQ(bar.goal().name, "");
  EXPECT_EQ(bar.goal().object_height, 0);
  EXPECT_EQ(bar.goal().symmetry, Goal::SYMMETRY_AUTO);
}

}  // namespace
}  // namespace mbncc::console
