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

TEST(LibraryModel, FindsByName) {
  LibraryModel library;
  std::vector<mbncc_vision::LearnedObject> objects(2);
  objects[0].name = "a";
  objects[1].name = "b";
  library.set_objects(objects);
  ASSERT_NE(library.find("b"), nullptr);
  EXPECT_EQ(library.find("c"), nullptr);
}

}  // namespace
}  // namespace mbncc::console
