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
  LessonControllerTest() { ros_.connect_to({}); }

  /// The operator presses Teach.
  void begin() {
    Q_EMIT ros_.status_heard(status());
    Q_EMIT bar_.teach_wanted();
    ASSERT_EQ(controller_.lesson().phase(), Phase::kRunning);
  }
  /// Another console, or a script, begins a lesson.
  void begin_elsewhere() {
    Q_EMIT ros_.status_heard(status("theirs"));
    ASSERT_EQ(controller_.lesson().goal(), "theirs");
  }
  /// The text that the bar shows from the next look at the clock on.
  QString shown() {
    controller_.look_at_clock(true);
    QString text;
    for (const auto* label : bar_.findChildren<QLabel*>()) text += label->text() + "\n";
    return text;
  }
  void end(const Result& outcome) {
    auto message = result(outcome.error_code, controller_.lesson().goal());
    message.result = outcome;
    Q_EMIT ros_.result_heard(message);
  }
  void list(const mbncc_vision::LearnedObject& object) {
    Q_EMIT ros_.objects_listed({object}, "", 0);
  }

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
  begin();
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
  begin();
  end(taken);
  EXPECT_TRUE(shown().contains("Replacing it discards its grasp.")) << shown().toStdString();
}

TEST_F(LessonControllerTest, AStoredObjectClearsTheFieldsOfTheNextOne) {
  mbncc_vision::LearnObjectGoal goal;
  goal.object_height = 0.03;
  bar_.show_goal(goal);
  begin();
  end(draft(Result::SUCCESS));
  EXPECT_EQ(bar_.goal().object_height, 0);
}

TEST_F(LessonControllerTest, AnObjectStoredByAnotherConsoleLeavesWhatTheOperatorHasEntered) {
  mbncc_vision::LearnObjectGoal goal;
  goal.object_height = 0.03;
  bar_.set_name("bracket");
  bar_.show_goal(goal);
  begin_elsewhere();
  end(draft(Result::SUCCESS));
  EXPECT_EQ(bar_.goal().name, "bracket");
  EXPECT_DOUBLE_EQ(bar_.goal().object_height, 0.03);
  EXPECT_TRUE(shown().contains("Learned")) << shown().toStdString();
  EXPECT_FALSE(shown().contains("Should it also be found")) << shown().toStdString();
}

TEST_F(LessonControllerTest, ANameThatAnotherConsoleFoundTakenIsNotAskedAboutHere) {
  Result taken = draft(Result::NAME_TAKEN);
  taken.object.name = "object_1";
  begin_elsewhere();
  end(taken);
  EXPECT_FALSE(shown().contains("is in the library already")) << shown().toStdString();
}

TEST_F(LessonControllerTest, AnObjectReplacedByAnotherConsoleIsNoEditOfThisOne) {
  mbncc_vision::LearnedObject known;
  known.name = "object_1";
  known.revision = 1;
  list(known);
  Q_EMIT ros_.status_heard(status());
  Q_EMIT strip_.view_wanted("object_1");
  end(draft(Result::CANCELLED));
  begin_elsewhere();
  Result stored = draft(Result::SUCCESS);
  stored.object.name = known.name;
  end(stored);
  EXPECT_FALSE(library_.library().can_undo());
}

}  // namespace
}  // namespace mbncc::console
