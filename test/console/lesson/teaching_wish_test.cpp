// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/teaching_wish.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

using Goal = mbncc_vision::LearnObjectGoal;
using What = TeachingWish::What;

mbncc_vision::LearnedObject stored_part() {
  mbncc_vision::LearnedObject stored;
  stored.name = "part";
  stored.label = "The part";
  stored.object_height = 0.03;
  stored.symmetry = Goal::SYMMETRY_2;
  return stored;
}

TEST(TeachingWish, AReplacedObjectKeepsItsHeightSymmetryAndLabel) {
  const auto stored = stored_part();
  const Goal goal = goal_of({What::kReplace, "part"}, Goal(), &stored);
  EXPECT_TRUE(goal.overwrite);
  EXPECT_EQ(goal.object_height, 0.03);
  EXPECT_EQ(goal.symmetry, Goal::SYMMETRY_2);
  EXPECT_EQ(goal.label, "The part");
}

TEST(TeachingWish, HeightAndSymmetryOfTheOperatorCountMoreThanThoseOfTheReplacedObject) {
  const auto stored = stored_part();
  Goal described;
  described.object_height = 0.02;
  described.symmetry = Goal::SYMMETRY_NONE;
  const Goal goal = goal_of({What::kReplace, "part"}, described, &stored);
  EXPECT_EQ(goal.object_height, 0.02);
  EXPECT_EQ(goal.symmetry, Goal::SYMMETRY_NONE);
}

TEST(TeachingWish, AnObjectThatReplacesNoneIsTaughtAsDescribed) {
  const auto stored = stored_part();
  EXPECT_EQ(goal_of({What::kNew, "part_2"}, Goal(), &stored).object_height, 0);
  EXPECT_EQ(goal_of({What::kReplace, "part"}, Goal(), nullptr).object_height, 0);
  EXPECT_EQ(goal_of({What::kView, "part"}, Goal(), &stored).object_height, 0);
}

TEST(TeachingWish, SaysWhatAReplacedObjectLoses) {
  auto stored = stored_part();
  EXPECT_EQ(loss_of(stored), "");
  stored.has_grasp = true;
  EXPECT_EQ(loss_of(stored), " Replacing it discards its grasp.");
  stored.min_score = 0.8f;
  EXPECT_EQ(loss_of(stored), " Replacing it discards its grasp and its own min_score.");
  stored.has_grasp = false;
  EXPECT_EQ(loss_of(stored), " Replacing it discards its own min_score.");
}

}  // namespace
}  // namespace mbncc::console
