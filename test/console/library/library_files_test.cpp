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

  /// As the learning nodelet lists the library in that folder.
  static ListedLibrary listed_in(ObjectLibrary& library) {
    ListedLibrary listed{library.folder(), folder_inode(library.folder()), {}};
    const auto snapshot = library.load();
    for (const auto& object : snapshot->objects) {
      auto& message = listed.objects.emplace_back();
      message.name = object->name;
      message.revision = object->revision;
      message.learned_at.fromSec(object->learned_at);
    }
    return listed;
  }
  ListedLibrary listed() { return listed_in(library_); }

  /// What is said about a library that this computer has no access to; "": nothing.
  static std::string refusal_of(const ListedLibrary& library) {
    try {
      check_library(library);
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  test::TemporaryFolder folder_;
  ObjectLibrary library_;
};

TEST_F(LibraryFiles, AnObjectIsCopiedAsOneFile) {
  export_object(listed(), "part", folder_ / "carried.png");
  EXPECT_EQ(import_object(listed(), folder_ / "carried.png"), "carried");
  EXPECT_TRUE(library_.load()->find("carried"));
  EXPECT_THROW(import_object(listed(), folder_ / "carried.png"), std::exception)
      << "the name is taken";
}

TEST_F(LibraryFiles, FilesThatAreNoObjectsAreRefused) {
  EXPECT_THROW(export_object(listed(), "none", folder_ / "x.png"), std::exception);
  EXPECT_THROW(import_object(listed(), folder_ / "none.png"), std::exception);
}

TEST_F(LibraryFiles, TheFolderIsUsedOnlyIfItIsTheOneThatTheNodeletUses) {
  EXPECT_EQ(refusal_of(listed()), "");
  EXPECT_NE(refusal_of({}).find("has not named"), std::string::npos);
  ListedLibrary elsewhere = listed();
  elsewhere.folder = folder_ / "elsewhere";
  EXPECT_NE(refusal_of(elsewhere).find("is not on this computer"), std::string::npos);
}

TEST_F(LibraryFiles, AFolderOfTheSamePathOnAnotherComputerIsNotUsed) {
  ListedLibrary remote = listed();
  ++remote.inode;
  EXPECT_NE(refusal_of(remote).find("is not the cell's library"), std::string::npos);
  EXPECT_THROW(import_object(remote, library_.folder() + "/part.png"), std::exception);
  EXPECT_THROW(export_object(remote, "part", folder_ / "x.png"), std::exception);
  EXPECT_THROW(earlier_revisions(remote, "part"), std::exception);
  EXPECT_THROW(deleted_objects(remote), std::exception);
  remote.inode = 0;
  EXPECT_NE(refusal_of(remote), "") << "unknown";
  ObjectLibrary empty(folder_ / "empty");
  ListedLibrary other = listed_in(empty);
  ++other.inode;
  EXPECT_NE(refusal_of(other), "") << "no object tells them apart";
}

TEST_F(LibraryFiles, ACopyOfTheLibraryIsNotUsedOnceItDiffers) {
  const ListedLibrary before = listed();
  library_.save(test::random_model(1, "part"), ObjectLibrary::Existing::kReplace);
  EXPECT_NE(refusal_of(before), "") << "another revision";
  ListedLibrary retaught = listed();
  retaught.objects.front().learned_at += ros::Duration(60);
  EXPECT_NE(refusal_of(retaught), "") << "the same revision of another lesson";
  ListedLibrary larger = listed();
  larger.objects.front().name = "other";
  EXPECT_NE(refusal_of(larger), "") << "an object that is missing here";
}

TEST_F(LibraryFiles, ReplacedRevisionsAreListedNewestFirst) {
  EXPECT_TRUE(earlier_revisions(listed(), "part").empty());
  for (int i = 0; i < 2; ++i)
    library_.save(test::random_model(1, "part"), ObjectLibrary::Existing::kReplace);
  const auto revisions = earlier_revisions(listed(), "part");
  ASSERT_EQ(revisions.size(), 2u);
  EXPECT_EQ(revisions[0].number, 2u);
  EXPECT_EQ(revisions[1].number, 1u);
  EXPECT_FALSE(revisions[0].image.empty());
}

TEST_F(LibraryFiles, DeletedObjectsAreListedOnceWithTheLastRevision) {
  library_.save(test::random_model(2, "other"), ObjectLibrary::Existing::kRefuse);
  library_.save(test::random_model(1, "part"), ObjectLibrary::Existing::kReplace);
  library_.save(test::random_model(2, "other"), ObjectLibrary::Existing::kReplace);
  EXPECT_TRUE(deleted_objects(listed()).empty()) << "both have earlier revisions only";
  library_.remove("part");
  const auto objects = deleted_objects(listed());
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].name, "part");
  EXPECT_EQ(objects[0].number, 2u);
}

}  // namespace
}  // namespace mbncc::console
