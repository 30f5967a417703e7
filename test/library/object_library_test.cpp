// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/library/object_library.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "library/models.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

using Existing = ObjectLibrary::Existing;

std::vector<std::string> names_of(const LibrarySnapshot& snapshot) {
  std::vector<std::string> names;
  for (const auto& object : snapshot.objects) names.push_back(object->name);
  return names;
}

TEST(ObjectLibrary, CreatesItsFolder) {
  TemporaryFolder folder;
  ObjectLibrary library(folder / "new");
  EXPECT_TRUE(library.load()->objects.empty());
  EXPECT_THROW(ObjectLibrary(""), FileError);
}

TEST(ObjectLibrary, TemporaryFilesOfOtherProgramsStay) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (const char* name : {".tmp-other", ".mbncc-tmp-crash"}) std::ofstream(folder / name) << "x";
  std::filesystem::create_symlink("elsewhere", folder / ".mbncc-tmp-link");
  library.save(random_model(1), Existing::kRefuse);
  EXPECT_TRUE(std::filesystem::exists(folder / ".tmp-other"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / ".mbncc-tmp-link"));
  EXPECT_FALSE(std::filesystem::exists(folder / ".mbncc-tmp-crash"));
}

TEST(ObjectLibrary, CreatesTheParentsOfItsFolderToo) {
  TemporaryFolder folder;
  for (const char* path : {"a/b/library", "c/library/"}) {
    ObjectLibrary library(folder / path);
    library.save(random_model(1), Existing::kRefuse);
    EXPECT_TRUE(std::filesystem::exists(folder / path + "/wrench.png")) << path;
  }
  EXPECT_THROW(ObjectLibrary(folder / "a/b/library/wrench.png"), FileError);
  try {
    ObjectLibrary(folder / "a/b/library/wrench.png/in/side");
    ADD_FAILURE() << "a library in a file";
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), folder / "a/b/library/wrench.png") << "what is no folder is named";
  }
  EXPECT_THROW(ObjectLibrary("/proc/none/library"), FileError);
}

TEST(ObjectLibrary, LoadsWhatWasSavedSortedByName) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (const char* name : {"nut", "Bolt", "gear_2", "gear"})
    expect_equal(library.save(random_model(7, name), Existing::kRefuse), random_model(7, name));
  const auto snapshot = ObjectLibrary(folder.path()).load();
  EXPECT_EQ(names_of(*snapshot), (std::vector<std::string>{"Bolt", "gear", "gear_2", "nut"}));
  expect_equal(*snapshot->find("gear"), random_model(7, "gear"));
  EXPECT_EQ(snapshot->find("wrench"), nullptr);
}

TEST(ObjectLibrary, UnchangedObjectsKeepTheirPointer) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1, "a"), Existing::kRefuse);
  library.save(random_model(2, "b"), Existing::kRefuse);
  const auto first = library.load();
  library.save(random_model(3, "b"), Existing::kReplace);
  const auto second = library.load();
  EXPECT_EQ(first->find("a"), second->find("a"));
  EXPECT_NE(first->find("b"), second->find("b"));
  expect_equal(*first->find("b"), random_model(2, "b"));
}

TEST(ObjectLibrary, DetectsChangesByOtherProcesses) {
  TemporaryFolder folder;
  ObjectLibrary reader(folder.path()), writer(folder.path());
  writer.save(random_model(1, "a"), Existing::kRefuse);
  EXPECT_TRUE(reader.changed_on_disk());
  reader.load();
  EXPECT_FALSE(reader.changed_on_disk());
  writer.save(random_model(2, "a"), Existing::kReplace);
  EXPECT_TRUE(reader.changed_on_disk());
  reader.load();
  writer.remove("a");
  EXPECT_TRUE(reader.changed_on_disk());
  reader.load();
  EXPECT_FALSE(reader.changed_on_disk());
}

TEST(ObjectLibrary, RefusesATakenNameUnlessReplacing) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  EXPECT_THROW(library.save(random_model(2), Existing::kRefuse), NameError);
  expect_equal(*library.load()->find("wrench"), random_model(1));
  EXPECT_EQ(library.save(random_model(2), Existing::kReplace).revision, 2u);
  expect_equal(*library.load()->find("wrench"), random_model(2));
}

TEST(ObjectLibrary, ReplacedAndRemovedRevisionsCanBeRestored) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (unsigned seed : {1, 2, 3}) library.save(random_model(seed), Existing::kReplace);
  EXPECT_EQ(library.restore("wrench", 1).revision, 4u);
  expect_equal(*library.load()->find("wrench"), random_model(1));
  EXPECT_EQ(library.restore("wrench").revision, 5u);
  expect_equal(*library.load()->find("wrench"), random_model(3));
  library.remove("wrench");
  EXPECT_EQ(library.load()->find("wrench"), nullptr);
  EXPECT_EQ(library.restore("wrench").revision, 6u);
  expect_equal(*library.load()->find("wrench"), random_model(3));
  EXPECT_THROW(library.restore("wrench", 77), std::invalid_argument);
  EXPECT_THROW(library.restore("gear"), std::invalid_argument);
}

// "wrench.1" is not an object, although the trash contains a "wrench.1.png".
TEST(ObjectLibrary, RestoresOnlyObjectNames) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (unsigned seed : {1, 2, 3}) library.save(random_model(seed), Existing::kReplace);
  std::filesystem::copy(folder / ".trash/wrench.1.png", folder / ".trash/wrench.1.2.png");
  for (const char* name : {"wrench.1", "wrench.", "", ".", "../wrench", "wrench.1.2"}) {
    try {
      library.restore(name);
      ADD_FAILURE() << name;
    } catch (const NameError& error) {
      EXPECT_EQ(error.code(), LearnError::kNameInvalid) << name;
    }
    EXPECT_THROW(library.remove(name), NameError) << name;
    EXPECT_THROW(library.rename(name, "gear", ""), NameError) << name;
    EXPECT_THROW(library.edit(name, [](ObjectModel&) {}), NameError) << name;
  }
  const auto snapshot = library.load();
  ASSERT_EQ(snapshot->objects.size(), 1u);
  expect_equal(*snapshot->find("wrench"), random_model(3));
  EXPECT_EQ(snapshot->find("wrench")->revision, 3u);
}

// As an object it could not be deleted, because deleting the wrench leaves this file.
TEST(ObjectLibrary, AFileNameWithARevisionIsNoSecondObject) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  for (const char* copy : {"wrench.1.png", "wrench..png", "wrench.png.png", "1wrench.png"}) {
    std::filesystem::copy(folder / "wrench.png", folder / copy);
    settle(folder / copy);
  }
  const auto snapshot = library.load();
  EXPECT_EQ(snapshot->objects.size(), 1u);
  ASSERT_EQ(snapshot->quarantined.size(), 4u);
  for (const auto& file : snapshot->quarantined) {
    EXPECT_TRUE(file.moved) << file.file;
    EXPECT_EQ(file.reason, "the file's name is not a valid object name") << file.file;
    EXPECT_FALSE(std::filesystem::exists(folder / file.file)) << file.file;
  }
}

TEST(ObjectLibrary, ForeignFilesInTheTrashDoNotBlockAName) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  // The largest number of 32 bits, the largest revision allowed, and a number beyond both.
  std::filesystem::create_directory(folder / ".trash");
  for (const char* revision : {"4294967295", "2000000000", "99999999999"})
    std::ofstream(folder / (".trash/wrench." + std::string(revision) + ".png")) << "no image";
  EXPECT_EQ(library.save(random_model(2), Existing::kReplace).revision, 2u);
  EXPECT_EQ(library.save(random_model(3), Existing::kReplace).revision, 3u);
  EXPECT_EQ(library.load()->find("wrench")->revision, 3u);
  library.remove("wrench");
  EXPECT_THROW(library.restore("wrench", 2000000000), FileError);
  EXPECT_EQ(library.restore("wrench").revision, 4u);  // the newest readable one
  expect_equal(*library.load()->find("wrench"), random_model(3));
}

TEST(ObjectLibrary, ALinkInPlaceOfTheTrashIsNotFollowed) {
  TemporaryFolder elsewhere;
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  for (const char* inner : {".trash", ".quarantine"})
    std::filesystem::create_directory_symlink(elsewhere.path(), folder / inner);
  const auto refused = [](auto&& change) {
    try {
      change();
      return false;
    } catch (const FileError& error) {
      return error.reason().find("not a folder of the library's own") != std::string::npos;
    }
  };
  EXPECT_TRUE(refused([&] { library.save(random_model(2), Existing::kReplace); }));
  EXPECT_TRUE(refused([&] { library.remove("wrench"); }));
  EXPECT_TRUE(refused([&] { library.restore("wrench"); }));
  EXPECT_TRUE(refused([&] { library.quarantine(); }));
  std::ofstream(folder / "broken.png") << "no image";
  settle(folder / "broken.png");
  const auto snapshot = library.load();
  expect_equal(*snapshot->find("wrench"), random_model(1));
  ASSERT_EQ(snapshot->quarantined.size(), 1u);
  EXPECT_FALSE(snapshot->quarantined[0].moved);
  EXPECT_TRUE(std::filesystem::is_empty(elsewhere.path()));
}

TEST(ObjectLibrary, EditThatMovesPosesIsANewRevision) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  const auto edited =
      library.edit("wrench", [](ObjectModel& model) { model.views.front().reference.x += 1; });
  EXPECT_EQ(edited.revision, 2u);
  EXPECT_EQ(library.edit("wrench", [](ObjectModel& model) { model.label = "w"; }).revision, 2u);
  EXPECT_EQ(library.edit("wrench", [](ObjectModel& model) { model.enabled = false; }).revision, 2u);
  EXPECT_EQ(library.edit("wrench", [](ObjectModel& model) { model.views.front().map.setTo(255); })
                .revision,
            3u);
  EXPECT_EQ(library.edit("wrench", [](ObjectModel& model) { model.symmetry = 2; }).revision, 4u);
  EXPECT_EQ(library.edit("wrench", [](ObjectModel& model) { model.symmetry = 2; }).revision, 4u);
  EXPECT_THROW(library.edit("wrench", [](ObjectModel& model) { model.symmetry = 13; }),
               std::invalid_argument);
  EXPECT_EQ(library.load()->find("wrench")->symmetry, 2);
  EXPECT_EQ(library.restore("wrench", 3).symmetry, std::nullopt);
  EXPECT_EQ(library.load()->find("wrench")->label, "w");
  EXPECT_THROW(library.edit("nut", [](ObjectModel&) {}), NameError);
}

TEST(ObjectLibrary, ThrowingEditChangesNothing) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  EXPECT_THROW(library.edit("wrench",
                            [](ObjectModel& model) {
                              model.label = "lost";
                              throw std::runtime_error("changed my mind");
                            }),
               std::runtime_error);
  expect_equal(*library.load()->find("wrench"), random_model(1));
}

TEST(ObjectLibrary, RenameChangesKeyAndLabel) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  library.save(random_model(2, "nut"), Existing::kRefuse);
  EXPECT_EQ(library.rename("wrench", "spanner", "").revision, 1u);
  expect_equal(*library.load()->find("spanner"), random_model(1, "spanner"));
  EXPECT_EQ(library.rename("spanner", "", "Spanner 10").label, "Spanner 10");
  EXPECT_EQ(names_of(*library.load()), (std::vector<std::string>{"nut", "spanner"}));
  EXPECT_THROW(library.rename("spanner", "nut", ""), std::invalid_argument);
  EXPECT_THROW(library.rename("spanner", "../x", ""), std::invalid_argument);
  EXPECT_THROW(library.rename("wrench", "w", ""), std::invalid_argument);
}

// The library is tested at this size; max_objects in the configuration limits the nodelet's to
// half.
TEST(ObjectLibrary, TwoThousandObjectsLoadAndReloadUnchanged) {
  constexpr unsigned kObjects = 2000;
  TemporaryFolder folder;
  const auto name_of = [](unsigned i) { return "part_" + std::to_string(i); };
  for (unsigned i = 0; i < kObjects; ++i) {
    const auto bytes = encode_object(random_model(i, name_of(i), 40));
    std::ofstream(folder / (name_of(i) + ".png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  ObjectLibrary library(folder.path());
  const auto timed_load = [&library](const char* what) {
    const auto start = std::chrono::steady_clock::now();
    auto snapshot = library.load();
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    testing::Test::RecordProperty(what, static_cast<int>(passed.count()));
    return snapshot;
  };
  const auto first = timed_load("load_ms");
  ASSERT_EQ(first->objects.size(), kObjects);
  EXPECT_TRUE(first->quarantined.empty());
  expect_equal(*first->find(name_of(1234)), random_model(1234, name_of(1234), 40));
  library.save(random_model(1, "another"), ObjectLibrary::Existing::kRefuse);
  EXPECT_TRUE(library.changed_on_disk());
  const auto second = timed_load("reload_ms");
  ASSERT_EQ(second->objects.size(), kObjects + 1);
  for (unsigned i = 0; i < kObjects; ++i)
    EXPECT_EQ(second->find(name_of(i)), first->find(name_of(i))) << "read again without need";
}

}  // namespace
}  // namespace mbncc::test
