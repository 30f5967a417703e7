// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "console/lesson_messages.hpp"

namespace mbncc::console {
namespace {

TEST(LessonModel, NoActionIsAllowedWithoutServer) {
  LessonModel lesson;
  EXPECT_EQ(lesson.phase(), Phase::kNoServer);
  EXPECT_FALSE(lesson.may_teach() || lesson.may_cancel() || lesson.may_decide());
  EXPECT_FALSE(lesson.headline().empty());
}

TEST(LessonModel, IsReadyOnceAServerExists) {
  EXPECT_TRUE(ready().may_teach());
}

TEST(LessonModel, ReportsALostServerWithinThreeSeconds) {
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

TEST(LessonModel, ALessonUnknownToTheServerIsLost) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  lesson.take_status(status("goal"), 1);
  lesson.take_status(status(), 2);
  EXPECT_EQ(lesson.phase(), Phase::kRunning);
  lesson.take_status(status(), 3.5);
  EXPECT_TRUE(lesson.may_teach());
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonModel, JoinsARunningLesson) {
  LessonModel lesson;
  lesson.take_status(status("theirs"), 0);
  EXPECT_EQ(lesson.phase(), Phase::kRunning);
  EXPECT_EQ(lesson.goal(), "theirs");
}

TEST(LessonModel, FeedbackShowsTheNextStepAndTheRemainingTime) {
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

TEST(LessonModel, EveryStageHasItsOwnHeadline) {
  std::set<std::string> headlines;
  for (std::uint8_t stage = Feedback::WAIT_IMAGE; stage <= Feedback::STORE; ++stage)
    headlines.insert(headline_of(stage));
  EXPECT_EQ(headlines.size(), std::size_t{Feedback::STORE} + 1);
}

TEST(LessonModel, TheResultStatesWhatHappenedAndWhatToDo) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::TIMEOUT), 5);
  EXPECT_TRUE(lesson.may_teach());
  EXPECT_EQ(lesson.detail(), "What happened. What to do.");
  EXPECT_EQ(lesson.level(), Level::kBad);
  EXPECT_FALSE(lesson.draft());
}

TEST(LessonModel, ARejectedLessonRaisesNoAlarm) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::REJECTED_BY_OPERATOR), 5);
  EXPECT_EQ(lesson.level(), Level::kUnknown);
}

TEST(LessonModel, ARecalledGoalStoredNothing) {
  LessonModel lesson = in_review();
  mbncc_vision::LearnObjectActionResult recalled;
  recalled.status.goal_id.id = "goal";
  recalled.status.status = actionlib_msgs::GoalStatus::RECALLED;
  lesson.take_result(recalled, 5);
  EXPECT_EQ(lesson.headline(), "Nothing was stored");
  EXPECT_EQ(outcome_of(recalled).error_code, Result::CANCELLED);
}

TEST(LessonModel, TheResultOfAnotherGoalDoesNotEndThisOne) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::BUSY, "theirs"), 5);
  EXPECT_TRUE(lesson.may_decide());
}

TEST(LessonModel, OnlyALessonBegunHereIsItsOwn) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  EXPECT_TRUE(lesson.is_own("goal"));
  EXPECT_FALSE(lesson.is_own("theirs"));
  lesson.take_result(result(Result::CANCELLED), 1);
  EXPECT_TRUE(lesson.is_own("goal")) << "when its end is evaluated";
  lesson.take_status(status("theirs"), 2);
  EXPECT_FALSE(lesson.is_own("theirs"));
  EXPECT_FALSE(lesson.is_own("goal"));
}

TEST(LessonModel, TheFeedbackOfAnotherLessonIsNotTakenForThisOne) {
  LessonModel lesson = ready();
  lesson.begin("refused", 0);
  lesson.take_draft(draft(Result::SUCCESS));
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 1);
  EXPECT_EQ(lesson.phase(), Phase::kRunning);
  EXPECT_FALSE(lesson.may_accept());
  lesson.take_result(result(Result::BUSY, "refused"), 1);
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 2);
  EXPECT_EQ(lesson.goal(), "goal");
  EXPECT_TRUE(lesson.may_accept());
}

TEST(LessonModel, ALessonIsLostThoughAnotherOneRuns) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  lesson.take_status(status("theirs"), 1);
  EXPECT_EQ(lesson.goal(), "goal") << "the server may not have it yet";
  lesson.take_status(status("theirs"), 2.5);
  EXPECT_EQ(lesson.headline(), "The lesson was lost");
  lesson.take_status(status("theirs"), 2.7);
  EXPECT_EQ(lesson.goal(), "theirs");
}

TEST(LessonModel, AnAnswerAfterTheEndChangesNothing) {
  LessonModel lesson = in_review();
  decide(lesson);
  lesson.take_result(result(Result::SUCCESS), 5);
  lesson.take_answer(true, "stored");
  EXPECT_TRUE(lesson.may_teach());
}

TEST(LessonModel, ADeadCameraIsNamedBeforeAndInALesson) {
  LessonModel lesson = ready();
  lesson.take_camera(false);
  EXPECT_EQ(lesson.headline(), "No image from the camera");
  EXPECT_NE(lesson.detail().find("cable"), std::string::npos);
  lesson.begin("goal", 0);
  lesson.take_feedback(feedback(Feedback::WAIT_IMAGE), 1);
  EXPECT_EQ(lesson.headline(), "No image from the camera");
  lesson.take_camera(true);
  EXPECT_EQ(lesson.headline(), "Keep the scene still");
}

mbncc_vision::LearnedObject listed(const std::string& name, std::uint32_t revision) {
  mbncc_vision::LearnedObject object;
  object.name = name;
  object.revision = revision;
  return object;
}

LessonModel learned(const std::string& name, std::uint32_t revision) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  auto end = result(Result::SUCCESS);
  end.result.object = listed(name, revision);
  lesson.take_result(end, 1);
  return lesson;
}

TEST(LessonModel, AResultIsWithdrawnWhenItsObjectIsGone) {
  LessonModel lesson = learned("part", 1);
  EXPECT_FALSE(lesson.take_library({listed("other", 1)})) << "the list may be an older one";
  EXPECT_FALSE(lesson.take_library({listed("other", 1), listed("part", 1)}));
  EXPECT_EQ(lesson.headline(), "Learned");
  EXPECT_TRUE(lesson.take_library({listed("other", 1)}));
  EXPECT_EQ(lesson.headline(), "Ready");
  EXPECT_FALSE(lesson.take_library({})) << "once";
}

TEST(LessonModel, AResultIsWithdrawnWhenItsRevisionIsReplaced) {
  LessonModel lesson = learned("part", 2);
  EXPECT_FALSE(lesson.take_library({listed("part", 2)}));
  EXPECT_TRUE(lesson.take_library({listed("part", 3)}));
}

TEST(LessonModel, LibraryChangesDoNotAffectARunningLesson) {
  LessonModel lesson = learned("part", 1);
  EXPECT_FALSE(lesson.take_library({listed("part", 1)}));
  lesson.begin("next", 2);
  EXPECT_FALSE(lesson.take_library({}));
  EXPECT_EQ(lesson.phase(), Phase::kRunning);
}

}  // namespace
}  // namespace mbncc::console
