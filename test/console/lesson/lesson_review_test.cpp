// SPDX-License-Identifier: BSD-3-Clause
// From the draft to the operator's decision.
#include <gtest/gtest.h>
#include <mbncc_vision/LearnQuality.h>

#include "console/lesson_messages.hpp"

namespace mbncc::console {
namespace {

LessonModel joined_in_review() {
  LessonModel lesson;
  lesson.take_draft(draft(Result::SUCCESS));
  lesson.take_status(status("goal"), 0);
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 1);
  return lesson;
}

TEST(LessonReview, JoinsALessonInReview) {
  LessonModel lesson;
  lesson.take_draft(draft(Result::SUCCESS));  // the server latches it for clients that connect late
  lesson.take_status(status("goal"), 0);
  EXPECT_FALSE(lesson.may_accept());
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 1);
  EXPECT_TRUE(lesson.draft());
  EXPECT_TRUE(lesson.may_accept());
}

TEST(LessonReview, TheDraftOfTheLessonBeforeIsNeverAccepted) {
  LessonModel lesson = in_review();
  lesson.take_result(result(Result::SUCCESS), 2);
  lesson.take_status(status("next"), 3);
  lesson.take_feedback(feedback(Feedback::WAIT_REMOVAL, 100, "next"), 4);
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM, 100, "next"), 5);
  EXPECT_FALSE(lesson.may_accept());
  lesson.take_draft(draft(Result::SUCCESS));
  EXPECT_TRUE(lesson.may_accept());
}

TEST(LessonReview, ARepeatedQuestionOnlyUpdatesTheTime) {
  LessonModel lesson = in_review();
  decide(lesson);
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM, 50), 2);
  EXPECT_EQ(lesson.phase(), Phase::kDeciding);
  EXPECT_EQ(lesson.time_left(2), "0:50 left");
  lesson.take_answer(false, "Not now.");
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM, 49), 3);
  EXPECT_EQ(lesson.detail(), "Not now.");
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonReview, AsksTogetherWithTheDraft) {
  const LessonModel lesson = in_review();
  EXPECT_TRUE(lesson.may_accept());
  EXPECT_TRUE(lesson.may_decide());
  ASSERT_TRUE(lesson.draft());
}

TEST(LessonReview, TheDetailOmitsTheAdvice) {
  LessonModel lesson = in_review();
  Result marginal = draft(Result::SUCCESS);
  marginal.object.quality.verdict = mbncc_vision::LearnQuality::MARGINAL;
  lesson.take_draft(marginal);
  EXPECT_EQ(lesson.detail(), "Verdict MARGINAL. Accept, correct or reject the outline.");
}

TEST(LessonReview, ABadDraftIsAcceptedOnlyAfterConfirmation) {
  LessonModel lesson = in_review(Result::QUALITY_BAD);
  EXPECT_FALSE(lesson.may_accept());
  EXPECT_TRUE(lesson.may_decide());
  EXPECT_TRUE(lesson.must_insist());
  EXPECT_NE(lesson.detail().find("tick that you have checked it"), std::string::npos);
  lesson.insist(true);
  EXPECT_TRUE(lesson.may_accept());
  EXPECT_NE(lesson.detail().find("Accept, correct or reject"), std::string::npos);
  lesson.take_draft(draft(Result::QUALITY_BAD));
  EXPECT_FALSE(lesson.may_accept());
}

TEST(LessonReview, TheDraftOfAnEarlierLessonIsNotShown) {
  LessonModel lesson = ready();
  lesson.take_draft(draft(Result::SUCCESS));
  EXPECT_FALSE(lesson.draft());
  lesson.begin("goal", 0);
  lesson.take_feedback(feedback(Feedback::WAIT_REMOVAL), 1);
  EXPECT_FALSE(lesson.draft());
}

TEST(LessonReview, TheDraftNumberChangesOnlyWithTheDraft) {
  LessonModel lesson = in_review();
  const int shown = lesson.draft_number();
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 2);
  lesson.look_at_clock(2);
  EXPECT_EQ(lesson.draft_number(), shown);
  lesson.take_draft(draft(Result::SUCCESS));
  EXPECT_NE(lesson.draft_number(), shown);
}

TEST(LessonReview, DraftAndFeedbackMayArriveInAnyOrder) {
  for (const bool draft_first : {true, false}) {
    LessonModel lesson = in_review();
    decide(lesson);
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

TEST(LessonReview, OnlyOneCommandIsSentAtATime) {
  LessonModel lesson = in_review();
  decide(lesson);
  EXPECT_EQ(lesson.phase(), Phase::kDeciding);
  EXPECT_FALSE(lesson.may_decide());
  lesson.take_answer(false, "There is no edit to undo.");
  EXPECT_TRUE(lesson.may_decide());
  EXPECT_EQ(lesson.detail(), "There is no edit to undo.");
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonReview, AnObjectThatCouldNotBeStoredCanBeAcceptedAgain) {
  LessonModel lesson = in_review();
  lesson.want(word(LessonModel::Word::ACCEPT));
  ASSERT_TRUE(lesson.next_word());
  lesson.take_feedback(feedback(Feedback::STORE), 2);
  lesson.take_answer(false, "Not stored: no space left.");
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 3);
  EXPECT_EQ(lesson.detail(), "Not stored: no space left.");
  EXPECT_EQ(lesson.level(), Level::kBad);
  EXPECT_TRUE(lesson.may_accept());
  lesson.take_feedback(feedback(Feedback::SEGMENT), 4);
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 5);
  EXPECT_NE(lesson.detail(), "Not stored: no space left.");
}

TEST(LessonReview, CorrectionsAreQueuedWhileOneIsComputed) {
  LessonModel lesson = in_review();
  decide(lesson);
  auto second = word(LessonModel::Word::EDIT);
  second.stroke_width = 7;
  lesson.want(second);
  EXPECT_EQ(lesson.waiting().size(), 2u);
  EXPECT_FALSE(lesson.next_word()) << "the server works";
  lesson.take_feedback(feedback(Feedback::SEGMENT), 2);
  lesson.want(word(LessonModel::Word::UNDO));
  lesson.take_answer(true, "");
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 3);
  const auto sent = lesson.next_word();
  ASSERT_TRUE(sent);
  EXPECT_EQ(sent->stroke_width, 7);
  lesson.take_answer(true, "");
  EXPECT_EQ(lesson.next_word()->command, LessonModel::Word::UNDO);
}

TEST(LessonReview, CommandsNameTheLessonThatIsShown) {
  LessonModel lesson = in_review();
  lesson.want(word(LessonModel::Word::ACCEPT));
  EXPECT_EQ(lesson.next_word()->goal_id, "goal");
}

TEST(LessonReview, AnAcceptDoesNotApplyToALaterDraft) {
  LessonModel lesson = in_review();
  decide(lesson);
  lesson.want(word(LessonModel::Word::ACCEPT));
  lesson.take_answer(true, "");
  EXPECT_FALSE(lesson.next_word()) << "another draft than that of the click";
}

TEST(LessonReview, QueuedCommandsEndWithTheLesson) {
  LessonModel lesson = in_review();
  decide(lesson);
  lesson.want(word(LessonModel::Word::EDIT));
  lesson.take_result(result(Result::CANCELLED), 5);
  EXPECT_TRUE(lesson.waiting().empty());
}

TEST(LessonReview, UndoIsOfferedIfThereIsACorrection) {
  LessonModel lesson = in_review();
  EXPECT_FALSE(lesson.may_undo());
  decide(lesson);
  lesson.take_answer(true, "");
  EXPECT_TRUE(lesson.may_undo());
  lesson.want(word(LessonModel::Word::UNDO));
  lesson.next_word();
  lesson.take_answer(true, "");
  EXPECT_FALSE(lesson.may_undo());
}

TEST(LessonReview, ACorrectionMayBeUndoneBeforeItIsAnswered) {
  LessonModel lesson = in_review();
  lesson.want(word(LessonModel::Word::EDIT));
  EXPECT_TRUE(lesson.may_undo()) << "it waits";
  lesson.next_word();
  EXPECT_TRUE(lesson.may_undo()) << "it is computed";
  lesson.want(word(LessonModel::Word::UNDO));
  EXPECT_FALSE(lesson.may_undo()) << "its undo waits already";
  lesson.take_answer(true, "");
  EXPECT_FALSE(lesson.may_undo());
  EXPECT_EQ(lesson.next_word()->command, LessonModel::Word::UNDO);
}

TEST(LessonReview, TheUndoOfARefusedCorrectionUndoesNoEarlierOne) {
  LessonModel lesson = in_review();
  decide(lesson);
  lesson.take_answer(true, "");
  lesson.want(word(LessonModel::Word::EDIT));
  lesson.next_word();
  lesson.want(word(LessonModel::Word::EDIT));
  lesson.want(word(LessonModel::Word::UNDO));
  lesson.want(word(LessonModel::Word::UNDO));
  lesson.take_answer(false, "A stroke outside of the image.");
  ASSERT_EQ(lesson.waiting().size(), 2u) << "the later correction and its own undo";
  EXPECT_EQ(lesson.waiting().front().command, LessonModel::Word::EDIT);
  EXPECT_TRUE(lesson.may_undo()) << "the first correction";
}

TEST(LessonReview, AnUndoBelongsToThePrecedingCorrection) {
  using Word = LessonModel::Word;
  LessonModel lesson = in_review();
  decide(lesson);
  for (const auto command : {Word::EDIT, Word::UNDO}) lesson.want(word(command));
  lesson.take_answer(false, "A stroke outside of the image.");
  EXPECT_EQ(lesson.waiting().size(), 2u) << "the undo is the later correction's";
  lesson = in_review();
  decide(lesson);
  for (const auto command : {Word::UNDO, Word::EDIT, Word::UNDO}) lesson.want(word(command));
  lesson.take_answer(false, "A stroke outside of the image.");
  ASSERT_EQ(lesson.waiting().size(), 2u);
  EXPECT_EQ(lesson.waiting().front().command, Word::EDIT);
}

TEST(LessonReview, WithoutAnAnswerUndoStaysAvailable) {
  LessonModel lesson = in_review();
  decide(lesson);
  lesson.want(word(LessonModel::Word::UNDO));
  lesson.take_no_answer("The learning nodelet does not answer.");
  EXPECT_EQ(lesson.waiting().size(), 1u) << "it may have been carried out";
  EXPECT_TRUE(lesson.may_undo());
  EXPECT_EQ(lesson.level(), Level::kBad);
}

TEST(LessonReview, SurplusUndosDoNotCountAgainstALaterCorrection) {
  LessonModel lesson = joined_in_review();
  for (int i = 0; i < 3; ++i) lesson.want(word(LessonModel::Word::UNDO));
  lesson.want(word(LessonModel::Word::EDIT));
  lesson.next_word();
  lesson.take_answer(false, "there is no edit to undo");
  EXPECT_TRUE(lesson.may_undo());
}

TEST(LessonReview, AJoinedReviewMayContainCorrections) {
  LessonModel lesson = joined_in_review();
  EXPECT_TRUE(lesson.may_undo());
  lesson.want(word(LessonModel::Word::UNDO));
  lesson.next_word();
  lesson.take_answer(false, "there is no edit to undo");
  EXPECT_FALSE(lesson.may_undo());
}

TEST(LessonReview, HasNoDeadlineIfTheServerSetsNone) {
  LessonModel lesson = in_review();
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM, 0), 2);
  EXPECT_EQ(lesson.time_left(3), "");
}

}  // namespace
}  // namespace mbncc::console
