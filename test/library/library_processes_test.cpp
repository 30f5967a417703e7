// SPDX-License-Identifier: BSD-3-Clause
// Several processes use one library: writers, readers, killed writers, and readers without
// permission.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include "library/models.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/kills.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

using Existing = ObjectLibrary::Existing;

constexpr unsigned kNobody = 65534;

// Runs `work` in a separate process; the exit code is 0 if it returns true.
pid_t in_process(const std::function<bool()>& work) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  bool good = false;
  try {
    good = work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  ::_exit(good ? 0 : 1);
}

bool succeeded(pid_t child) {
  int status = 0;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(LibraryProcesses, TwoWritersAndAReaderDoNotDisturbEachOther) {
  constexpr int kSaves = 25;
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(0), Existing::kRefuse);
  const auto write = [&folder](unsigned first_seed) {
    return [&folder, first_seed] {
      ObjectLibrary writer(folder.path());
      for (unsigned i = 0; i < kSaves; ++i)
        writer.save(random_model(first_seed + i), Existing::kReplace);
      return true;
    };
  };
  const pid_t one = in_process(write(100)), two = in_process(write(200));
  for (int i = 0; i < 200; ++i) {
    const auto snapshot = library.load();
    ASSERT_TRUE(snapshot->quarantined.empty());
    ASSERT_NE(snapshot->find("wrench"), nullptr);
  }
  EXPECT_TRUE(succeeded(one));
  EXPECT_TRUE(succeeded(two));
  EXPECT_EQ(library.load()->find("wrench")->revision, 1u + 2 * kSaves);
  for (unsigned revision = 1; revision <= 2 * kSaves; ++revision)
    EXPECT_TRUE(
        std::filesystem::exists(folder / (".trash/wrench." + std::to_string(revision) + ".png")));
}

// The delay before each kill is what this test varies; it does not wait for anything.
TEST(LibraryProcesses, KillsAtRandomTimesLoseNothing) {
  const int kills = kills_wanted(100);
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(0), Existing::kRefuse);
  std::mt19937 random(42);
  for (int kill = 0; kill < kills; ++kill) {
    const pid_t child = in_process([&folder] {
      ObjectLibrary writer(folder.path());
      while (true) writer.save(random_model(1), Existing::kReplace);
      return true;
    });
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution<int>(0, 20000)(random)));
    ::kill(child, SIGKILL);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    const auto snapshot = library.load();
    ASSERT_TRUE(snapshot->quarantined.empty());
    const auto object = snapshot->find("wrench");
    ASSERT_NE(object, nullptr);
    expect_equal(*object, random_model(object->revision == 1 ? 0 : 1));
  }
}

TEST(LibraryProcesses, ReadersWithoutWritePermissionLoad) {
  TemporaryFolder folder;
  ObjectLibrary(folder.path()).save(random_model(1), Existing::kRefuse);
  std::ofstream(folder / "broken.png") << "not an image";
  settle(folder / "broken.png");
  ::chmod(folder.path().c_str(), 0555);
  const pid_t child = in_process([&folder] {
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) return false;  // root may write everywhere
    ObjectLibrary library(folder.path());
    const auto snapshot = library.load();
    bool refused = false;
    try {
      library.save(random_model(2), Existing::kReplace);
    } catch (const FileError&) {
      refused = true;
    }
    return refused && snapshot->find("wrench") != nullptr && snapshot->quarantined.size() == 1 &&
           !snapshot->quarantined[0].moved && !library.changed_on_disk();
  });
  EXPECT_TRUE(succeeded(child));
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_TRUE(std::filesystem::exists(folder / "broken.png"));
}

}  // namespace
}  // namespace mbncc::test
