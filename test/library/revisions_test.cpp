// SPDX-License-Identifier: BSD-3-Clause
// A name and a revision identify one object, as long as the trash is not emptied.
#include <gtest/gtest.h>

#include "library/models.hpp"
#include "mbncc/library/object_library.hpp"
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

}  // namespace
}  // namespace mbncc::test
