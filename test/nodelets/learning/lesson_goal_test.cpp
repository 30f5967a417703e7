// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_goal.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/learning/lesson_draft.hpp"

namespace mbncc::nodelets {
namespace {

using Goal = mbncc_vision::LearnObjectGoal;
using Result = mbncc_vision::LearnObjectResult;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kManyObjects = 100;

LibrarySnapshot library_of(const std::vector<std::string>& names) {
  LibrarySnapshot library;
  for (const auto& name : names) {
    auto model = std::make_shared<ObjectModel>();
    model->name = name;
    library.objects.push_back(model);
  }
  return library;
}

Goal goal_named(const std::string& name) {
  Goal goal;
  goal.name = name;
  return goal;
}

int code(const Goal& goal, const LibrarySnapshot& library, int max_objects = kManyObjects) {
  const auto fault = check_goal(goal, library, max_objects);
  if (!fault) return Result::SUCCESS;
  EXPECT_FALSE(fault->message.empty());
  EXPECT_FALSE(fault->hint.empty());
  return fault->error_code;
}

TEST(CheckGoal, AcceptsANewName) {
  EXPECT_EQ(code(goal_named("cup"), library_of({"box"})), Result::SUCCESS);
  EXPECT_EQ(code(goal_named(""), library_of({"box"})), Result::SUCCESS);
}

TEST(CheckGoal, RefusesBadNames) {
  for (const std::string name : {"../../x", "1cup", "a b", "cup/", "tasse\xc3\xa9", "_x", "a-b"})
    EXPECT_EQ(code(goal_named(name), {}), Result::NAME_INVALID) << name;
  EXPECT_EQ(code(goal_named(std::string(10000, 'a')), {}), Result::NAME_INVALID);
  EXPECT_EQ(code(goal_named(std::string("cup\0", 4)), {}), Result::NAME_INVALID);
}

TEST(CheckGoal, RequiresOverwriteOrAddViewForAKnownName) {
  Goal goal = goal_named("cup");
  const auto library = library_of({"cup"});
  EXPECT_EQ(code(goal, library), Result::NAME_TAKEN);
  goal.overwrite = true;
  EXPECT_EQ(code(goal, library), Result::SUCCESS);
  goal.add_view = true;
  EXPECT_EQ(code(goal, library), Result::NAME_TAKEN);
  goal.overwrite = false;
  EXPECT_EQ(code(goal, library), Result::SUCCESS);
}

TEST(CheckGoal, AddsNoViewToAnUnknownObject) {
  Goal goal = goal_named("cup");
  goal.add_view = true;
  EXPECT_EQ(code(goal, {}), Result::NAME_UNKNOWN);
  goal.name.clear();
  EXPECT_EQ(code(goal, {}), Result::NAME_INVALID);
}

TEST(CheckGoal, KeepsTheLibraryWithinItsLimit) {
  Goal goal = goal_named("cup");
  EXPECT_EQ(code(goal, library_of({"a", "b"}), 2), Result::STORAGE);
  goal.name = "a";
  goal.overwrite = true;
  EXPECT_EQ(code(goal, library_of({"a", "b"}), 2), Result::SUCCESS);
}

TEST(CheckGoal, RequiresTheInputOfTheMode) {
  Goal goal = goal_named("cup");
  goal.point.y = std::numeric_limits<double>::quiet_NaN();
  for (const int mode :
       {int(Goal::ROI), int(Goal::OUTLINE), int(Goal::MASK), int(Goal::CLICK), 77}) {
    goal.mode = static_cast<std::uint8_t>(mode);
    EXPECT_EQ(code(goal, {}), Result::REGION_INVALID) << mode;
  }
  goal.mode = Goal::ROI;
  goal.roi = to_msg(cv::Rect(10, 10, 50, 50));
  EXPECT_EQ(code(goal, {}), Result::SUCCESS);
  goal.mode = Goal::CLICK;
  goal.point.y = 10;
  EXPECT_EQ(code(goal, {}), Result::SUCCESS);
  goal.mode = Goal::OUTLINE;
  goal.outline = to_msg(std::vector<cv::Point2f>{{1, 1}, {30, 1}, {1, 30}});
  EXPECT_EQ(code(goal, {}), Result::SUCCESS);
  goal.outline.points[0].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(code(goal, {}), Result::REGION_INVALID);
}

TEST(CheckGoal, RefusesInvalidNumbers) {
  Goal goal = goal_named("cup");
  for (const double height : {kNaN, -0.1, 1000.0}) {
    goal.object_height = height;
    EXPECT_EQ(code(goal, {}), Result::REGION_INVALID) << height;
  }
  goal = goal_named("cup");
  for (const int symmetry : {13, 100, 254}) {
    goal.symmetry = static_cast<std::uint8_t>(symmetry);
    EXPECT_EQ(code(goal, {}), Result::REGION_INVALID) << symmetry;
  }
  for (const int symmetry : {0, 1, 2, 5, 12, 255}) {
    goal.symmetry = static_cast<std::uint8_t>(symmetry);
    EXPECT_EQ(code(goal, {}), Result::SUCCESS) << symmetry;
  }
  goal = goal_named("cup");
  goal.set_reference = true;
  goal.reference.theta = kNaN;
  EXPECT_EQ(code(goal, {}), Result::REGION_INVALID);
  goal.reference.theta = 0;
  goal.reference.x = 1e9;
  EXPECT_EQ(code(goal, {}), Result::REGION_INVALID);
  goal = goal_named("cup");
  goal.timeout = ros::Duration(-1);
  EXPECT_EQ(code(goal, {}), Result::TIMEOUT);
  goal = goal_named("cup");
  goal.timeout = ros::Duration(1e6);
  EXPECT_EQ(code(goal, {}), Result::TIMEOUT);
  for (const std::string& label :
       {std::string(201, 'x'), std::string("a\nb"), std::string("\xff")}) {
    goal.label = label;
    EXPECT_EQ(code(goal, {}), Result::NAME_INVALID);
  }
}

TEST(NameFor, TakesTheFirstFreeNumber) {
  EXPECT_EQ(name_for(goal_named("cup"), {}), "cup");
  EXPECT_EQ(name_for(goal_named(""), {}), "object_1");
  EXPECT_EQ(name_for(goal_named(""), library_of({"object_1", "object_2"})), "object_3");
}

class ToLesson : public ::testing::Test {
 protected:
  const cv::Mat image_ = cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(9));
  Goal goal_ = goal_named("cup");

  GoalLesson made(const cv::Mat& after = {}) { return to_lesson(goal_, "cup", image_, after); }
};

TEST_F(ToLesson, ChangeHasBothImages) {
  goal_.object_height = 0.02;
  const auto made = this->made(image_.clone());
  EXPECT_FALSE(made.fault);
  EXPECT_FALSE(made.lesson.after.empty());
  EXPECT_TRUE(made.lesson.region.empty());
  EXPECT_DOUBLE_EQ(made.lesson.object_height, 0.02);
  EXPECT_FALSE(made.lesson.symmetry) << "goals of earlier clients declare nothing";
  EXPECT_FALSE(made.lesson.reference);
  goal_.symmetry = Goal::SYMMETRY_ROUND;
  EXPECT_EQ(this->made(image_.clone()).lesson.symmetry, 0);
}

TEST_F(ToLesson, RegionHasNoAfterImage) {
  goal_.mode = Goal::ROI;
  goal_.roi = to_msg(cv::Rect(4, 5, 30, 20));
  const auto made = this->made(image_);
  EXPECT_TRUE(made.lesson.after.empty());
  EXPECT_EQ(made.lesson.region, cv::Rect(4, 5, 30, 20));
  goal_.roi.width = 61;
  ASSERT_TRUE(this->made().fault);
  EXPECT_EQ(this->made().fault->error_code, Result::REGION_INVALID);
}

TEST_F(ToLesson, MaskMustHaveTheImagesSize) {
  goal_.mode = Goal::MASK;
  goal_.mask = encode_image(cv::Mat::zeros(48, 64, CV_8UC1));
  EXPECT_FALSE(made().fault);
  EXPECT_EQ(made().lesson.map.size(), image_.size());
  goal_.mask = encode_image(cv::Mat::zeros(48, 65, CV_8UC1));
  EXPECT_EQ(made().fault->error_code, Result::IMAGE_MISMATCH);
  goal_.mask.encoding = "32FC1";
  EXPECT_EQ(made().fault->error_code, Result::ENCODING);
}

TEST_F(ToLesson, RefusesImagesOfTwoSizes) {
  EXPECT_EQ(made(cv::Mat(40, 64, CV_8UC3)).fault->error_code, Result::IMAGE_MISMATCH);
}

TEST_F(ToLesson, UsesTheReferenceIfSet) {
  goal_.set_reference = true;
  goal_.reference.x = 7;
  ASSERT_TRUE(made().lesson.reference);
  EXPECT_DOUBLE_EQ(made().lesson.reference->x, 7);
}

}  // namespace
}  // namespace mbncc::nodelets
