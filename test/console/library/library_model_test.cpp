// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_model.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

using Request = LibraryModel::Request;

TEST(LibraryModel, EveryEditCanBeUndone) {
  LibraryModel library;
  EXPECT_FALSE(library.can_undo());
  library.done(LibraryModel::enable("a", false));
  EXPECT_EQ(library.undo().command, Request::ENABLE);
  library.done(LibraryModel::rename("a", "b"));
  EXPECT_EQ(library.undo().name, "b");
  EXPECT_EQ(library.undo().new_name, "a");
  library.done(LibraryModel::remove("b"));
  EXPECT_EQ(library.undo().command, Request::RESTORE);
  EXPECT_EQ(library.undo().name, "b");
}

TEST(LibraryModel, UndoRestoresThePreviousSymmetry) {
  LibraryModel library;
  mbncc_vision::LearnedObject object;
  object.name = "a";
  object.symmetry = 2;
  library.set_objects({object});
  const auto request = library.declare("a", 255);
  EXPECT_EQ(request.command, Request::SET_SYMMETRY);
  EXPECT_EQ(request.name, "a");
  EXPECT_EQ(request.symmetry, 255);
  object.symmetry = 255;
  library.set_objects({object});  // the list may arrive before the answer
  library.done(request);
  EXPECT_EQ(library.undo().command, Request::SET_SYMMETRY);
  EXPECT_EQ(library.undo().name, "a");
  EXPECT_EQ(library.undo().symmetry, 2);
  EXPECT_EQ(library.undo_text(), "Undo: symmetry of 'a'");
}

TEST(LibraryModel, UndoRevertsOneEditAtATime) {
  LibraryModel library;
  library.done(LibraryModel::remove("a"));
  library.done(LibraryModel::remove("b"));
  EXPECT_NE(library.undo_text().find("'b'"), std::string::npos);
  library.undone();
  EXPECT_NE(library.undo_text().find("'a'"), std::string::npos);
  library.undone();
  EXPECT_FALSE(library.can_undo());
}

TEST(LibraryModel, UndoOfARestoreDeletesTheObjectAgain) {
  LibraryModel library;
  library.done(library.restore("a", 3));
  EXPECT_EQ(library.undo().command, Request::DELETE) << "it was deleted before";
  EXPECT_EQ(library.undo_text(), "Undo: delete 'a' again");
  mbncc_vision::LearnedObject object;
  object.name = "a";
  object.revision = 4;
  library.set_objects({object});
  library.done(library.restore("a", 3));
  EXPECT_EQ(library.undo().command, Request::RESTORE);
  EXPECT_EQ(library.undo().revision, 4u);
}

TEST(LibraryModel, UndoRestoresThePreviousThreshold) {
  LibraryModel library;
  mbncc_vision::LearnedObject object;
  object.name = "a";
  library.set_objects({object});
  library.done(library.set_threshold("a", 0.4));
  EXPECT_EQ(library.undo().command, Request::SET_THRESHOLD);
  EXPECT_TRUE(library.undo().clear) << "it had none";
  EXPECT_EQ(library.undo_text(), "Undo: min_score of 'a'");
  object.min_score = 0.4f;
  library.set_objects({object});
  const auto request = library.set_threshold("a", 0);
  EXPECT_TRUE(request.clear);
  library.done(request);
  EXPECT_FALSE(library.undo().clear);
  EXPECT_FLOAT_EQ(library.undo().min_score, 0.4f);
}

TEST(LibraryModel, AReplacedRevisionCanBeRestored) {
  LibraryModel library;
  mbncc_vision::LearnedObject object;
  object.name = "part";
  object.revision = 4;
  library.set_objects({object});
  library.begin_lesson("another");
  library.retaught("another");
  EXPECT_FALSE(library.can_undo()) << "nothing was there before";
  library.begin_lesson("part");
  object.revision = 5;
  library.set_objects({object});  // the list may arrive before the result
  library.retaught("part");
  ASSERT_TRUE(library.can_undo());
  EXPECT_EQ(library.undo().command, LibraryModel::Request::RESTORE);
  EXPECT_EQ(library.undo().revision, 4u);
  EXPECT_NE(library.undo_text().find("revision 4"), std::string::npos);
}

}  // namespace
}  // namespace mbncc::console
