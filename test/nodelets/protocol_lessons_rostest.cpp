// A running lesson: a second goal, its time limit, the operator's word.
#include <std_srvs/Trigger.h>

#include <cmath>

#include "nodelets/messages.hpp"
#include "nodelets/protocol.hpp"

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

TEST_F(Protocol, AsksTheOperatorBeforeStoring) {
  EXPECT_FALSE(confirm(ConfirmLearning::Request::ACCEPT).success) << "no lesson waits";
  Goal goal = given("checked");
  goal.confirm = true;
  std::string id = teacher_.send(goal);
  const auto waits = [&] { return teacher_.heard(id, Teacher::Feedback::WAIT_CONFIRM); };
  ASSERT_TRUE(spin_until(waits));
  EXPECT_TRUE(names().empty());
  const auto roi = teacher_.last_feedback(id).roi;
  EXPECT_NEAR(roi.x_offset + roi.width / 2.0, part_.pose.x, 10);
  EXPECT_NEAR(roi.y_offset + roi.height / 2.0, part_.pose.y, 10);
  EXPECT_NEAR(std::hypot(roi.width, roi.height), part_.object.diameter, 25);
  EXPECT_FALSE(confirm(ConfirmLearning::Request::UNDO).success) << "no edit yet";
  EXPECT_FALSE(confirm(ConfirmLearning::Request::EDIT).success) << "nothing to edit";
  ConfirmLearning::Request edit_reference;
  edit_reference.command = ConfirmLearning::Request::EDIT;
  edit_reference.set_reference = true;
  edit_reference.reference.x = 150;
  edit_reference.reference.y = 110;
  EXPECT_TRUE(call<ConfirmLearning>("confirm_learning", edit_reference).success);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::UNDO).success);
  ConfirmLearning::Request stroke;
  stroke.command = ConfirmLearning::Request::EDIT;
  stroke.stroke_width = 9;
  stroke.exclude.push_back(to_msg(std::vector<cv::Point2f>{{160, 80}, {160, 160}}));
  const auto area = [&] { return confirm(ConfirmLearning::Request::UNDO).quality.area; };
  const double whole = area();
  const auto cut = call<ConfirmLearning>("confirm_learning", stroke);
  EXPECT_TRUE(cut.success) << cut.message;
  EXPECT_LT(cut.quality.area, whole - 100);
  EXPECT_EQ(area(), whole) << "taken back";
  stroke.exclude[0].points[0].x = std::nanf("");
  EXPECT_FALSE(call<ConfirmLearning>("confirm_learning", stroke).success);
  EXPECT_TRUE(call<ConfirmLearning>("confirm_learning", edit_reference).success);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::ACCEPT).success);
  const Result accepted = teacher_.await(id).result;
  EXPECT_EQ(accepted.error_code, Result::SUCCESS);
  EXPECT_DOUBLE_EQ(accepted.object.reference.x, 150);

  goal.name = "rejected";
  id = teacher_.send(goal);
  ASSERT_TRUE(spin_until(waits));
  EXPECT_TRUE(confirm(ConfirmLearning::Request::REJECT).success);
  EXPECT_EQ(teacher_.await(id).result.error_code, Result::REJECTED_BY_OPERATOR);
  EXPECT_EQ(names(), std::vector<std::string>{"checked"});
  EXPECT_TRUE(edit("checked", EditObject::Request::DELETE).success);
}

}  // namespace
}  // namespace mbncc::nodelets
