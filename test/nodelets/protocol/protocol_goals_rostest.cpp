// SPDX-License-Identifier: BSD-3-Clause
// Reasons for refusing a lesson's goal, and lessons made from goals.

#include "nodelets/conversion/messages.hpp"
#include "nodelets/protocol/protocol.hpp"

namespace mbncc::nodelets {
namespace {

TEST_F(Protocol, RejectsBadGoalsBeforeAnythingMoves) {
  for (const std::string name : {"../../x", "1part", "a b", "\xc3\xa9"})
    expect_refused(given(name), Result::NAME_INVALID);
  expect_refused(given(std::string(10000, 'x')), Result::NAME_INVALID);
  Goal goal = given("unknown");
  goal.add_view = true;
  expect_refused(goal, Result::NAME_UNKNOWN);
  goal = given("clicked");
  goal.mode = Goal::CLICK;
  goal.point.x = std::nan("");
  expect_refused(goal, Result::REGION_INVALID);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, NamesAnObjectByItselfAndRefusesATakenName) {
  const Result first = teacher_.teach(given(""));
  ASSERT_EQ(first.error_code, Result::SUCCESS) << first.message;
  EXPECT_EQ(first.object.name, "object_1");
  EXPECT_EQ(first.object.revision, 1u);
  expect_refused(given("object_1"), Result::NAME_TAKEN);
  Goal goal = given("object_1");
  goal.overwrite = true;
  EXPECT_EQ(teacher_.teach(goal).object.revision, 2u);
  EXPECT_TRUE(edit("object_1", EditObject::Request::DELETE).success);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, TeachesByRegionOutlineAndMask) {
  cv::Mat plain_table = scene_.render({part_}, 1);
  plain_table.setTo(cv::Scalar(150, 155, 160), ~scene_.true_map(part_));
  Goal goal = given("by_region");
  goal.mode = Goal::ROI;
  goal.roi = to_msg(cv::Rect(100, 60, 60, 120));
  const Result doubtful = teacher_.teach(goal);
  EXPECT_EQ(doubtful.error_code, Result::QUALITY_BAD) << "the region cuts the part in two";
  EXPECT_FALSE(doubtful.hint.empty());
  goal.roi = to_msg(cv::Rect(100, 60, 120, 120));
  goal.before = encode_image(plain_table);
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  goal = given("by_mask");
  goal.mode = Goal::MASK;
  goal.mask = encode_image(scene_.true_map(part_));
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  goal = given("by_outline");
  goal.mode = Goal::OUTLINE;
  goal.outline = to_msg(std::vector<cv::Point2f>{{130, 100}, {190, 105}, {185, 145}, {135, 140}});
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  goal = given("by_click");
  goal.mode = Goal::CLICK;
  goal.point.x = part_.pose.x;
  goal.point.y = part_.pose.y;
  goal.before = encode_image(plain_table);
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  EXPECT_EQ(names(), (std::vector<std::string>{"by_click", "by_mask", "by_outline", "by_region"}));
  for (const auto& name : names()) EXPECT_TRUE(edit(name, EditObject::Request::DELETE).success);
}

TEST_F(Protocol, RefusesInconsistentAndMismatchedImages) {
  Goal goal = given("part");
  goal.before.step += 1;
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::ENCODING);
  goal = given("part");
  goal.after.encoding = "32FC1";
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::ENCODING);
  goal = given("part");
  goal.after = encode_image(cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::IMAGE_MISMATCH);
  goal = given("part");
  goal.after = goal.before;
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::NO_CHANGE);
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace mbncc::nodelets
