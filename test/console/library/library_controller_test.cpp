// SPDX-License-Identifier: BSD-3-Clause
// The answers of the library are emitted by the test.
#include "console/library/library_controller.hpp"

#include <gtest/gtest.h>

#include <QStringList>

#include "console/library/library_strip.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/temporary_folder.hpp"

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

TEST_F(LibraryControllerTest, NothingIsShownOrImportedFromAFolderThatIsNotTheCells) {
  QStringList told;
  QObject::connect(&controller_, &LibraryController::told, &controller_,
                   [&told](bool success, const QString& sentence) {
                     if (!success) told << sentence;
                   });
  test::TemporaryFolder folder;
  const auto list_at = [&](std::uint64_t inode) {
    Q_EMIT ros_.objects_listed({}, QString::fromStdString(folder.path()), inode);
  };
  list_at(folder_inode(folder.path()) + 1);
  Q_EMIT strip_.deleted_wanted();
  Q_EMIT strip_.history_wanted("part");
  Q_EMIT strip_.import_wanted();
  Q_EMIT strip_.export_wanted("part");
  ASSERT_EQ(told.size(), 4);
  for (const auto& sentence : told)
    EXPECT_TRUE(sentence.contains("is not the cell's library")) << sentence.toStdString();
  list_at(folder_inode(folder.path()));
  Q_EMIT strip_.deleted_wanted();
  EXPECT_EQ(told.size(), 4);
  controller_.forget_folder();
  Q_EMIT strip_.deleted_wanted();
  EXPECT_EQ(told.size(), 5) << "the nodelet's successor may use another folder";
}

}  // namespace
}  // namespace mbncc::console
