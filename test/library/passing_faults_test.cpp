// SPDX-License-Identifier: BSD-3-Clause
// Faults that pass although nobody changes the file.
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "library/fault_injection.hpp"
#include "library/models.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

FaultPlan failing_read(int error) {
  FaultPlan plan;
  plan.at = 0;
  plan.error = error;
  return plan;
}

TEST(PassingFaults, AnObjectThatCouldNotBeReadIsReadOnceItCan) {
  for (const int error : {EIO, EMFILE, ENOMEM, EACCES}) {
    TemporaryFolder folder;
    ObjectLibrary library(folder.path());
    library.save(random_model(1), ObjectLibrary::Existing::kRefuse);
    {
      const ArmedFault fault(failing_read(error));
      const auto snapshot = library.load();
      EXPECT_TRUE(snapshot->objects.empty());
      ASSERT_EQ(snapshot->quarantined.size(), 1u);
      EXPECT_FALSE(snapshot->quarantined[0].moved);
    }
    {
      const ArmedFault fault(failing_read(error));
      EXPECT_FALSE(library.changed_on_disk()) << "a lasting fault is not reported every second";
    }
    EXPECT_TRUE(library.changed_on_disk());
    EXPECT_NE(library.load()->find("wrench"), nullptr);
    EXPECT_FALSE(library.changed_on_disk());
  }
}

void write_part(const std::string& path, double share) {
  const auto bytes = encode_object(random_model(1));
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(share * static_cast<double>(bytes.size())));
}

TEST(PassingFaults, AFileThatIsBeingCopiedStaysInPlace) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  const std::string file = folder / "wrench.png";
  for (const double share : {0.0, 0.3, 0.6}) {
    write_part(file, share);
    const auto snapshot = library.load();
    ASSERT_EQ(snapshot->quarantined.size(), 1u);
    EXPECT_FALSE(snapshot->quarantined[0].moved) << share;
    EXPECT_THROW(library.edit("wrench", [](ObjectModel&) {}), FileError);
    EXPECT_FALSE(library.changed_on_disk());
  }
  write_part(file, 1);
  EXPECT_TRUE(library.changed_on_disk());
  EXPECT_NE(library.load()->find("wrench"), nullptr);
  EXPECT_TRUE(library.quarantine().empty());
}

TEST(PassingFaults, ACopyThatWasBrokenOffIsQuarantinedInTheEnd) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  write_part(folder / "wrench.png", 0.5);
  library.load();
  settle(folder / "wrench.png");
  EXPECT_TRUE(library.changed_on_disk());
  EXPECT_TRUE(library.load()->quarantined.at(0).moved);
  // A wrong clock must not keep a damaged file in place.
  write_part(folder / "nut.png", 0.5);
  std::filesystem::last_write_time(
      folder / "nut.png", std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_TRUE(library.load()->quarantined.at(0).moved);
}

// What a load finds if another program replaces a damaged file, dated back like any copy that keeps
// times, just before the library is locked.
std::shared_ptr<const LibrarySnapshot> load_while_replaced(const std::string& folder,
                                                           double share) {
  const std::string file = folder + "/wrench.png";
  FaultPlan plan;
  plan.at = 5;
  plan.meanwhile = [&] {
    write_part(file, share);
    settle(file);
  };
  write_part(file, 0.5);
  settle(file);
  ObjectLibrary library(folder);
  const ArmedFault replacing(plan);
  auto snapshot = library.load();
  EXPECT_EQ(fault_plan().calls.at(5), "flock");
  return snapshot;
}

TEST(PassingFaults, AFileThatIsReplacedBeforeItsQuarantineIsReadAgain) {
  TemporaryFolder folder;
  const auto whole = load_while_replaced(folder.path(), 1);
  EXPECT_NE(whole->find("wrench"), nullptr);
  EXPECT_TRUE(whole->quarantined.empty());
  const auto longer = load_while_replaced(folder.path(), 0.7);
  ASSERT_EQ(longer->quarantined.size(), 1u);
  EXPECT_FALSE(longer->quarantined[0].moved) << "it is still growing";
  EXPECT_TRUE(std::filesystem::exists(folder / "wrench.png"));
  EXPECT_TRUE(ObjectLibrary(folder.path()).quarantine().empty());
}

}  // namespace
}  // namespace mbncc::test
