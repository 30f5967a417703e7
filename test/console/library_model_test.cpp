#include "console/library_model.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

using Request = LibraryModel::Request;

TEST(LibraryModel, EveryEditHasItsWayBack) {
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

TEST(LibraryModel, UndoGoesBackStepByStep) {
  LibraryModel library;
  library.done(LibraryModel::remove("a"));
  library.done(LibraryModel::remove("b"));
  EXPECT_NE(library.undo_text().find("'b'"), std::string::npos);
  library.undone();
  EXPECT_NE(library.undo_text().find("'a'"), std::string::npos);
  library.undone();
  EXPECT_FALSE(library.can_undo());
}

}  // namespace
}  // namespace mbncc::console
