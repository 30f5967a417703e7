// SPDX-License-Identifier: BSD-3-Clause
// The answers of the library are emitted by the test.
#include "console/library/library_controller.hpp"

#include <gtest/gtest.h>

#include "console/library/library_strip.hpp"

namespace mbncc::console {
namespace {

using Edit = mbncc_vision::EditObject::Request;

class LibraryControllerTest : public testing::Test {
 protected:
  void disable(const std::string& name) {
    Q_EMIT strip_.edit_wanted(LibraryModel::enable(name, false));
  }
  void answer(const Edit& request, bool settled, bool success) {
    Q_EMIT ros_.edited(request, settled, success, "");
  }
  const LibraryModel& library() const { return controller_.library(); }

  RosLink ros_;
  LibraryStrip strip_;
  LibraryController controller_{ros_, strip_, nullptr};
};

TEST_F(LibraryControllerTest, UndoWaitsForTheAnswerToTheEditThatItReverts) {
  disable("bracket");
  answer(LibraryModel::enable("bracket", false), true, true);
  disable("wrench");
  Q_EMIT strip_.undo_wanted();
  answer(LibraryModel::enable("wrench", false), true, true);
  ASSERT_TRUE(library().can_undo());
  EXPECT_EQ(library().undo().command, Edit::ENABLE);
  EXPECT_EQ(library().undo().name, "wrench");
}

TEST_F(LibraryControllerTest, AnUndoThatFailedForAPassingReasonCanBeRepeated) {
  disable("bracket");
  answer(LibraryModel::enable("bracket", false), true, true);
  Q_EMIT strip_.undo_wanted();
  answer(library().undo(), false, false);
  ASSERT_TRUE(library().can_undo());
  Q_EMIT strip_.undo_wanted();
  answer(library().undo(), true, false);
  EXPECT_FALSE(library().can_undo()) << "it would be refused again";
}

}  // namespace
}  // namespace mbncc::console
