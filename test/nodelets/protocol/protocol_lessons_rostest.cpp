// SPDX-License-Identifier: BSD-3-Clause
// A running lesson: a second goal, its time limit, the operator's decision.
#include <std_srvs/Trigger.h>

#include <cmath>
#include <filesystem>

#include "nodelets/conversion/messages.hpp"
#include "nodelets/protocol/protocol.hpp"

namespace mbncc::nodelets {
namespace {

using actionlib_msgs::GoalStatus;

TEST_F(Protocol, KeepsTheRunningLessonWhenASecondGoalComes) {
  const ros::WallTimer playing = play();
  Goal live;
  live.name = "live";
  const std::string first = teacher_.send(live);
  ASSERT_TRUE(spin_until([&] { return teacher_.heard(first, Teacher::Feedback::WAIT_REMOVAL); }));
  for (int i = 0; i < 3; ++i) expect_refused(given("second"), Result::BUSY);
  EXPECT_FALSE(call<std_srvs::Trigger>("mark_grasp", {}).success) << "no gripper_frame is set";
  EXPECT_FALSE(teacher_.ended(first));
  teacher_.cancel(first);
  const auto end = teacher_.await(first);
  EXPECT_EQ(end.status.status, GoalStatus::PREEMPTED);
  EXPECT_EQ(end.result.error_code, Result::CANCELLED);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, EndsALessonAtItsTimeLimit) {
  Goal goal;
  goal.name = "late";
  goal.timeout = ros::Duration(0.5);
  goal.already_moved = false;
  {
    const ros::WallTimer playing = play();
    const auto end = teacher_.await(teacher_.send(goal));
    EXPECT_EQ(end.status.status, GoalStatus::ABORTED);
    EXPECT_TRUE(end.result.error_code == Result::TIMEOUT ||
                end.result.error_code == Result::NOT_STILL ||
                end.result.error_code == Result::NO_IMAGE)
        << end.result.message;
  }
  const Result next = teacher_.teach(given("next"));
  EXPECT_EQ(next.error_code, Result::SUCCESS) << next.message;
  EXPECT_TRUE(edit("next", EditObject::Request::DELETE).success);
}

// A lesson that waits for the operator's decision.
class Review : public Protocol {
 protected:
  std::string begin(const std::string& name, double timeout = 0) {
    Goal goal = given(name);
    goal.timeout = ros::Duration(timeout);
    goal.confirm = true;
    const std::string id = teacher_.send(goal);
    EXPECT_TRUE(spin_until([&] { return teacher_.heard(id, Teacher::Feedback::WAIT_CONFIRM); }));
    return id;
  }

  ConfirmLearning::Response change(const ConfirmLearning::Request& request) {
    return call<ConfirmLearning>("confirm_learning", request);
  }

  static ConfirmLearning::Request new_reference(double x, double y) {
    ConfirmLearning::Request request;
    request.command = ConfirmLearning::Request::EDIT;
    request.set_reference = true;
    request.reference.x = x;
    request.reference.y = y;
    return request;
  }

  static ConfirmLearning::Request stroke_beside(const std::vector<cv::Point2f>& line) {
    ConfirmLearning::Request request;
    request.command = ConfirmLearning::Request::EDIT;
    request.stroke_width = 9;
    request.exclude.push_back(to_msg(line));
    return request;
  }
};

TEST_F(Review, AsksTheOperatorBeforeStoring) {
  EXPECT_FALSE(confirm(ConfirmLearning::Request::ACCEPT).success) << "no lesson waits";
  std::string id = begin("checked");
  EXPECT_TRUE(names().empty());
  EXPECT_TRUE(teacher_.last_feedback(id).remaining.isZero()) << "a review has no deadline";
  const auto roi = teacher_.last_feedback(id).roi;
  EXPECT_NEAR(roi.x_offset + roi.width / 2.0, part_.pose.x, 10);
  EXPECT_NEAR(roi.y_offset + roi.height / 2.0, part_.pose.y, 10);
  EXPECT_NEAR(std::hypot(roi.width, roi.height), part_.object.diameter, 25);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::ACCEPT).success);
  EXPECT_EQ(teacher_.await(id).result.error_code, Result::SUCCESS);

  id = begin("rejected", 80);
  EXPECT_FALSE(teacher_.last_feedback(id).remaining.isZero()) << "the goal's own holds";
  EXPECT_TRUE(confirm(ConfirmLearning::Request::REJECT).success);
  EXPECT_EQ(teacher_.await(id).result.error_code, Result::REJECTED_BY_OPERATOR);
  EXPECT_EQ(names(), std::vector<std::string>{"checked"});
  EXPECT_TRUE(edit("checked", EditObject::Request::DELETE).success);
}

TEST_F(Review, ACommandForAnotherLessonIsRefused) {
  const std::string id = begin("meant");
  ConfirmLearning::Request request;
  request.command = ConfirmLearning::Request::ACCEPT;
  request.goal_id = id + "_earlier";
  EXPECT_FALSE(change(request).success);
  request.command = ConfirmLearning::Request::REJECT;
  request.goal_id = id;
  EXPECT_TRUE(change(request).success);
  EXPECT_EQ(teacher_.await(id).result.error_code, Result::REJECTED_BY_OPERATOR);
}

TEST_F(Review, EditsCanBeUndoneAndTheLastOnesAreStored) {
  const std::string id = begin("edited");
  EXPECT_FALSE(confirm(ConfirmLearning::Request::UNDO).success) << "no edit yet";
  EXPECT_FALSE(confirm(ConfirmLearning::Request::EDIT).success) << "nothing to edit";
  EXPECT_TRUE(change(new_reference(150, 110)).success);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::UNDO).success);
  const auto area = [&] { return confirm(ConfirmLearning::Request::UNDO).quality.area; };
  const double whole = area();
  const auto cut = change(stroke_beside({{160, 80}, {160, 160}}));
  EXPECT_TRUE(cut.success) << cut.message;
  EXPECT_LT(cut.quality.area, whole - 100);
  EXPECT_EQ(area(), whole) << "taken back";
  EXPECT_FALSE(change(stroke_beside({{std::nanf(""), 80}, {160, 160}})).success);
  EXPECT_FALSE(change(new_reference(1e9, 110)).success);
  EXPECT_TRUE(change(new_reference(150, 110)).success);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::ACCEPT).success);
  const Result accepted = teacher_.await(id).result;
  EXPECT_EQ(accepted.error_code, Result::SUCCESS);
  EXPECT_DOUBLE_EQ(accepted.object.reference.x, 150);
  EXPECT_TRUE(edit("edited", EditObject::Request::DELETE).success);
}

TEST_F(Review, GoesOnWithItsCorrectionsIfTheObjectCannotBeStored) {
  std::string folder;
  ASSERT_TRUE(ros::param::get("learning/library_path", folder));
  const std::string id = begin("corrected");
  EXPECT_TRUE(change(new_reference(150, 110)).success);
  std::filesystem::rename(folder, folder + "_away");
  const auto failed = confirm(ConfirmLearning::Request::ACCEPT);
  std::filesystem::rename(folder + "_away", folder);
  EXPECT_FALSE(failed.success);
  EXPECT_EQ(failed.message.rfind("Not stored: ", 0), 0u) << failed.message;
  EXPECT_TRUE(confirm(ConfirmLearning::Request::ACCEPT).success);
  const Result stored = teacher_.await(id).result;
  EXPECT_EQ(stored.error_code, Result::SUCCESS) << stored.message;
  EXPECT_DOUBLE_EQ(stored.object.reference.x, 150);
  EXPECT_TRUE(edit("corrected", EditObject::Request::DELETE).success);
}

}  // namespace
}  // namespace mbncc::nodelets
