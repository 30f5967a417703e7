// SPDX-License-Identifier: BSD-3-Clause
// The messages of the learning nodelet are emitted by the test.
#include "console/lesson/lesson_controller.hpp"

#include <gtest/gtest.h>

#include <QLabel>

#include "console/image/image_view.hpp"
#include "console/lesson/lesson_bar.hpp"
#include "console/lesson/review_pane.hpp"
#include "console/lesson_messages.hpp"
#include "console/library/library_controller.hpp"
#include "console/library/library_strip.hpp"

namespace mbncc::console {
namespace {

class LessonControllerTest : public testing::Test {
 protected:
  /// The text that the bar shows from the next look at the clock on.
  QString shown() {
    controller_.look_at_clock(true);
    QString text;
    for (const auto* label : bar_.findChildren<QLabel*>()) text += label->text() + "\n";
    return text;
  }
  void end(const Result& outcome) {
    auto message = result(outcome.error_code);
    message.result = outcome;
    Q_EMIT ros_.feedback_heard(feedback(Feedback::STORE));
    Q_EMIT ros_.result_heard(message);
  }
  void list(const mbncc_vision::LearnedObject& object) { Q_EMIT ros_.objects_listed({object}, ""); }

  SteadyClock clock_;
  RosLink ros_;
  LessonBar bar_;
  ReviewPane review_;
  ImageView image_;
  LibraryStrip strip_;
  LibraryController library_{ros_, strip_, nullptr};
  LessonController controller_{clock_, ros_, {bar_, review_, image_, strip_}, library_, nullptr};
};

TEST_F(LessonControllerTest, AsksAboutTheNameThatTheServerChose) {
  Result taken = draft(Result::NAME_TAKEN);
  taken.object.name = "object_1";
  end(taken);
  EXPECT_TRUE(shown().contains("'object_1' is in the library already")) << shown().toStdString();
}

TEST_F(LessonControllerTest, SaysWhatReplacingAnObjectDiscards) {
  mbncc_vision::LearnedObject known;
  known.name = "object_1";
  known.has_grasp = true;
  list(known);
  Result taken = draft(Result::NAME_TAKEN);
  taken.object.name = known.name;
  end(taken);
  EXPECT_TRUE(shown().contains("Replacing it discards its grasp.")) << shown().toStdString();
}

TEST_F(LessonControllerTest, AStoredObjectClearsTheFieldsOfTheNextOne) {
  mbncc_vision::LearnObjectGoal goal;
  goal.object_height = 0.03;
  bar_.show_goal(goal);
  end(draft(Result::SUCCESS));
  EXPECT_EQ(bar_.goal().object_height, 0);
}

}  // namespace
}  // namespace mbncc::console
