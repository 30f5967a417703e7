// SPDX-License-Identifier: BSD-3-Clause
// A name and a revision identify one object, as long as the trash is not emptied.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "library/models.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

using Existing = ObjectLibrary::Existing;

TEST(ObjectLibrary, RevisionNumbersAreNeverReused) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  library.remove("wrench");
  EXPECT_EQ(library.save(random_model(2), Existing::kRefuse).revision, 2u);
}

TEST(ObjectLibrary, RevisionNumbersAreNotReusedAfterAQuarantine) {
  // Of the whole description, and of nothing, is left.
  for (const int left : {4000, 100}) {
    TemporaryFolder folder;
    ObjectLibrary library(folder.path());
    for (unsigned seed : {1, 2, 3}) library.save(random_model(seed), Existing::kReplace);
    ASSERT_GT(std::filesystem::file_size(folder / "wrench.png"), 4000u);
    std::filesystem::resize_file(folder / "wrench.png", left);
    settle(folder / "wrench.png");
    EXPECT_EQ(library.load()->quarantined.size(), 1u);
    EXPECT_EQ(library.save(random_model(4), Existing::kRefuse).revision, 4u) << left;
    EXPECT_EQ(library.save(random_model(5), Existing::kReplace).revision, 5u) << left;
  }
}

TEST(ObjectLibrary, ADescriptionInTheQuarantineTellsTheRevisionWithoutATrash) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (unsigned seed : {1, 2, 3}) library.save(random_model(seed), Existing::kReplace);
  std::filesystem::remove_all(folder / ".trash");
  std::filesystem::resize_file(folder / "wrench.png", 4000);
  settle(folder / "wrench.png");
  library.load();
  EXPECT_EQ(library.save(random_model(4), Existing::kRefuse).revision, 4u);
}

TEST(ObjectLibrary, RenameToAUsedNameTakesANewRevision) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (unsigned seed : {1, 2}) library.save(random_model(seed, "nut"), Existing::kReplace);
  library.remove("nut");
  library.save(random_model(3), Existing::kRefuse);
  EXPECT_EQ(library.rename("wrench", "nut", "").revision, 3u);
}

TEST(ObjectLibrary, ANameLeftByARenameKeepsItsRevisions) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (unsigned seed : {1, 2, 3}) library.save(random_model(seed), Existing::kReplace);
  EXPECT_EQ(library.rename("wrench", "spanner", "").revision, 3u);
  EXPECT_EQ(library.save(random_model(4), Existing::kRefuse).revision, 4u);
  expect_equal(library.restore("wrench", 3), random_model(3));
  EXPECT_EQ(library.load()->find("wrench")->revision, 5u);
}

TEST(ObjectLibrary, WhatARenameLeftIsNotTheNewestRevisionOfItsOldName) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  library.rename("wrench", "spanner", "");
  EXPECT_THROW(library.restore("wrench"), std::exception) << "the spanner is no wrench";
  library.save(random_model(2), Existing::kRefuse);
  library.remove("wrench");
  expect_equal(library.restore("wrench"), random_model(2));
}

// The object takes the higher revision of its new name before it is renamed.
TEST(ObjectLibrary, ARenameToAUsedNameLeavesNoRevisionFree) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (unsigned seed : {1, 2, 3}) library.save(random_model(seed, "nut"), Existing::kReplace);
  library.remove("nut");
  library.save(random_model(4), Existing::kRefuse);
  EXPECT_EQ(library.rename("wrench", "nut", "").revision, 4u);
  EXPECT_EQ(library.save(random_model(5), Existing::kRefuse).revision, 5u);
}

TEST(ObjectLibrary, KnowsWhetherAnObjectWasRemovedAfterItsFileWasQuarantined) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  // The kernel dates files by its last tick.
  const auto wait_for_tick = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  for (unsigned seed : {1, 2}) library.save(random_model(seed), Existing::kReplace);
  std::filesystem::resize_file(folder / "wrench.png", 100);
  settle(folder / "wrench.png");
  wait_for_tick();
  library.load();
  const QuarantinedFile file = library.quarantine().at(0);
  EXPECT_FALSE(library.trashed_since("wrench", file)) << "replaced before";
  library.restore("wrench");
  EXPECT_FALSE(library.trashed_since("wrench", file));
  // A copy that keeps times is as old as the original.
  settle(folder / "wrench.png");
  wait_for_tick();
  library.remove("wrench");
  EXPECT_TRUE(library.trashed_since("wrench", file));
  EXPECT_FALSE(library.trashed_since("nut", file));
}

}  // namespace
}  // namespace mbncc::test
