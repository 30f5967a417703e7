// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "library/models.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::console {
namespace {

class LibraryFiles : public testing::Test {
 protected:
  LibraryFiles() : library_(folder_ / "library") {
    library_.save(test::random_model(1, "part"), ObjectLibrary::Existing::kRefuse);
  }

  test::TemporaryFolder folder_;
  ObjectLibrary library_;
};

TEST_F(LibraryFiles, AnObjectIsCopiedAsOneFile) {
  export_object(library_.folder(), "part", folder_ / "carried.png");
  EXPECT_EQ(import_object(library_.folder(), folder_ / "carried.png"), "carried");
  EXPECT_TRUE(library_.load()->find("carried"));
  EXPECT_THROW(import_object(library_.folder(), folder_ / "carried.png"), std::exception)
      << "the name is taken";
}

TEST_F(LibraryFiles, FilesThatAreNoObjectsAreRefused) {
  EXPECT_THROW(export_object(library_.folder(), "none", folder_ / "x.png"), std::exception);
  EXPECT_THROW(import_object(library_.folder(), folder_ / "none.png"), std::exception);
  EXPECT_THROW(earlier_revisions(folder_ / "elsewhere", "part"), std::exception);
}

TEST_F(LibraryFiles, ReplacedRevisionsAreListedNewestFirst) {
  EXPECT_TRUE(earlier_revisions(library_.folder(), "part").empty());
  for (int i = 0; i < 2; ++i)
    library_.save(test::random_model(1, "part"), ObjectLibrary::Existing::kReplace);
  const auto revisions = earlier_revisions(library_.folder(), "part");
  ASSERT_EQ(revisions.size(), 2u);
  EXPECT_EQ(revisions[0].number, 2u);
  EXPECT_EQ(revisions[1].number, 1u);
  EXPECT_FALSE(revisions[0].image.empty());
}

TEST_F(LibraryFiles, DeletedObjectsAreListedOnceWithTheLastRevision) {
  library_.save(test::random_model(2, "other"), ObjectLibrary::Existing::kRefuse);
  library_.save(test::random_model(1, "part"), ObjectLibrary::Existing::kReplace);
  library_.save(test::random_model(2, "other"), ObjectLibrary::Existing::kReplace);
  EXPECT_TRUE(deleted_objects(library_.folder()).empty()) << "both have earlier revisions only";
  library_.remove("part");
  const auto objects = deleted_objects(library_.folder());
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].name, "part");
  EXPECT_EQ(objects[0].number, 2u);
}

}  // namespace
}  // namespace mbncc::console
