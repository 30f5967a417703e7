#include "console/lesson_model.hpp"

#include <gtest/gtest.h>
#include <mbncc_vision/LearnObjectFeedback.h>

#include <set>

namespace mbncc::console {
namespace {

using Phase = LessonModel::Phase;
using Feedback = mbncc_vision::LearnObjectFeedback;
using Result = mbncc_vision::LearnObjectResult;

actionlib_msgs::GoalStatusArray status(const std::string& alive = "") {
  actionlib_msgs::GoalStatusArray array;
  if (alive.empty()) return array;
  auto& goal = array.status_list.emplace_back();
  goal.goal_id.id = alive;
  goal.status = actionlib_msgs::GoalStatus::ACTIVE;
  return array;
}

mbncc_vision::LearnObjectActionFeedback feedback(std::uint8_t stage, double remaining = 100) {
  mbncc_vision::LearnObjectActionFeedback message;
  message.status.goal_id.id = "goal";
  message.feedback.stage = stage;
  message.feedback.progress = 0.5f;
  message.feedback.remaining = ros::Duration(remaining);
  message.feedback.message = "Do something.";
  return message;
}

mbncc_vision::LearnObjectActionResult result(std::int16_t code, const std::string& goal = "goal") {
  mbncc_vision::LearnObjectActionResult message;
  message.status.goal_id.id = goal;
  message.result.error_code = code;
  message.result.message = "What happened.";
  message.result.hint = "What to do.";
  return message;
}

Result draft(std::int16_t code) {
  Result draft;
  draft.error_code = code;
  return draft;
}

LessonModel ready() {
  LessonModel lesson;
  lesson.take_status(status(), 0);
  return lesson;
}

LessonModel in_review(std::int16_t code = Result::SUCCESS) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  lesson.take_draft(draft(code));
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 1);
  return lesson;
}

TEST(LessonModel, NothingMayBeDoneWithoutServer) {
  LessonModel lesson;
  EXPECT_EQ(lesson.phase(), Phase::kNoServer);
  EXPECT_FALSE(lesson.may_teach() || lesson.may_cancel() || lesson.may_decide());
  EXPECT_FALSE(lesson.headline().empty());
}

TEST(LessonModel, AServerMakesItReady) {
  EXPECT_TRUE(ready().may_teach());
}

TEST(LessonModel, SaysWithinThreeSecondsThatTheServerIsGone) {
  for (const bool running : {false, true}) {
    LessonModel lesson = ready();
    if (running) lesson.begin("goal", 0);
    lesson.look_at_clock(1.9);
    EXPECT_NE(lesson.phase(), Phase::kNoServer);
    lesson.look_at_clock(2.5);
    EXPECT_EQ(lesson.phase(), Phase::kNoServer);
    EXPECT_EQ(lesson.level(), Level::kBad);
    lesson.take_status(status(), 10);
    EXPECT_TRUE(lesson.may_teach());
  }
}

TEST(LessonModel, ALessonThatTheServerForgotIsLost) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  lesson.take_status(status("goal"), 1);
  lesson.take_status(status(), 2);
  EXPECT_EQ(lesson.phase(), Phase::kRunning);
  lesson.take_status(status(), 3.5);
  EXPECT_TRUE(lesson.may_teach());
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonModel, JoinsALessonThatIsUnderWay) {
  LessonModel lesson;
  lesson.take_status(status("theirs"), 0);
  EXPECT_EQ(lesson.phase(), Phase::kRunning);
  EXPECT_EQ(lesson.goal(), "theirs");
}

TEST(LessonModel, JoinsALessonInReview) {
  LessonModel lesson;
  lesson.take_draft(draft(Result::SUCCESS));  // kept by the server for those who come late
  lesson.take_status(status("goal"), 0);
  EXPECT_FALSE(lesson.may_accept());
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 1);
  EXPECT_TRUE(lesson.draft());
  EXPECT_TRUE(lesson.may_accept());
}

TEST(LessonModel, TheDraftOfTheLessonBeforeIsNeverAccepted) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::SUCCESS), 2);
  lesson.take_status(status("next"), 3);
  lesson.take_feedback(feedback(Feedback::WAIT_REMOVAL), 4);
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 5);
  EXPECT_FALSE(lesson.may_accept());
  lesson.take_draft(draft(Result::SUCCESS));
  EXPECT_TRUE(lesson.may_accept());
}

TEST(LessonModel, ARepeatedQuestionOnlyTellsTheTime) {
  LessonModel lesson = in_review();
  lesson.decide();
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM, 50), 2);
  EXPECT_EQ(lesson.phase(), Phase::kDeciding);
  EXPECT_EQ(lesson.time_left(2), "0:50 left");
  lesson.take_answer(false, "Not now.");
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM, 49), 3);
  EXPECT_EQ(lesson.detail(), "Not now.");
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonModel, FeedbackTellsWhatToDoAndHowLongIsLeft) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  lesson.take_feedback(feedback(Feedback::WAIT_REMOVAL, 65), 1);
  EXPECT_EQ(lesson.headline(), "Take the object away");
  EXPECT_EQ(lesson.detail(), "Do something.");
  EXPECT_EQ(lesson.time_left(1), "1:05 left");
  EXPECT_EQ(lesson.time_left(61), "0:05 left");
  EXPECT_EQ(lesson.time_left(90), "0:00 left");
  EXPECT_TRUE(lesson.waits_for_scene());
  EXPECT_TRUE(lesson.may_cancel());
  EXPECT_FALSE(lesson.may_decide());
}

TEST(LessonModel, EveryStageHasAHeadlineOfItsOwn) {
  std::set<std::string> headlines;
  for (std::uint8_t stage = Feedback::WAIT_IMAGE; stage <= Feedback::STORE; ++stage)
    headlines.insert(headline_of(stage));
  EXPECT_EQ(headlines.size(), std::size_t{Feedback::STORE} + 1);
}

TEST(LessonModel, AsksWithTheDraft) {
  const LessonModel lesson = in_review();
  EXPECT_TRUE(lesson.may_accept());
  EXPECT_TRUE(lesson.may_decide());
  ASSERT_TRUE(lesson.draft());
}

TEST(LessonModel, ABadDraftIsAcceptedOnlyOnTheOperatorsWord) {
  LessonModel lesson = in_review(Result::QUALITY_BAD);
  EXPECT_FALSE(lesson.may_accept());
  EXPECT_TRUE(lesson.may_decide());
  EXPECT_TRUE(lesson.must_insist());
  lesson.insist(true);
  EXPECT_TRUE(lesson.may_accept());
  lesson.take_draft(draft(Result::QUALITY_BAD));
  EXPECT_FALSE(lesson.may_accept());
}

TEST(LessonModel, TheDraftOfAnEarlierLessonIsNotShown) {
  LessonModel lesson = ready();
  lesson.take_draft(draft(Result::SUCCESS));
  EXPECT_FALSE(lesson.draft());
  lesson.begin("goal", 0);
  lesson.take_feedback(feedback(Feedback::WAIT_REMOVAL), 1);
  EXPECT_FALSE(lesson.draft());
}

TEST(LessonModel, TheDraftsNumberChangesWithTheDraftAlone) {
  LessonModel lesson = in_review();
  const int shown = lesson.draft_number();
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 2);
  lesson.look_at_clock(2);
  EXPECT_EQ(lesson.draft_number(), shown);
  lesson.take_draft(draft(Result::SUCCESS));
  EXPECT_NE(lesson.draft_number(), shown);
}

TEST(LessonModel, ACorrectionBringsItsDraftInAnyOrder) {
  for (const bool draft_first : {true, false}) {
    LessonModel lesson = in_review();
    lesson.decide();
    lesson.take_feedback(feedback(Feedback::SEGMENT), 2);
    EXPECT_TRUE(lesson.draft());
    Result corrected = draft(Result::SUCCESS);
    corrected.object.name = "corrected";
    if (draft_first) lesson.take_draft(corrected);
    lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 3);
    if (!draft_first) lesson.take_draft(corrected);
    ASSERT_TRUE(lesson.draft());
    EXPECT_EQ(lesson.draft()->object.name, "corrected");
    EXPECT_TRUE(lesson.may_accept());
  }
}

TEST(LessonModel, OneWordAtATime) {
  LessonModel lesson = in_review();
  lesson.decide();
  EXPECT_EQ(lesson.phase(), Phase::kDeciding);
  EXPECT_FALSE(lesson.may_decide());
  lesson.take_answer(false, "There is no edit to undo.");
  EXPECT_TRUE(lesson.may_decide());
  EXPECT_EQ(lesson.detail(), "There is no edit to undo.");
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonModel, TheEndSaysWhatHappenedAndWhatToDo) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::TIMEOUT), 5);
  EXPECT_TRUE(lesson.may_teach());
  EXPECT_EQ(lesson.detail(), "What happened. What to do.");
  EXPECT_EQ(lesson.level(), Level::kBad);
  EXPECT_FALSE(lesson.draft());
}

TEST(LessonModel, ARejectedLessonIsNoAlarm) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::REJECTED_BY_OPERATOR), 5);
  EXPECT_EQ(lesson.level(), Level::kUnknown);
}

TEST(LessonModel, TheResultOfAnotherGoalDoesNotEndThisOne) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::BUSY, "theirs"), 5);
  EXPECT_TRUE(lesson.may_decide());
}

TEST(LessonModel, AnAnswerAfterTheEndChangesNothing) {
  LessonModel lesson = in_review();
  lesson.decide();
  lesson.take_result(result(Result::SUCCESS), 5);
  lesson.take_answer(true, "stored");
  EXPECT_TRUE(lesson.may_teach());
}

}  // namespace
}  // namespace mbncc::console
