// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/library/shared_library.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>

#include "library/models.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

TEST(SharedLibrary, AChangeIsDoneThoughTheLibraryCannotBeReadAfterwards) {
  test::TemporaryFolder folder;
  const std::string path = folder / "library", away = folder / "away";
  std::size_t objects = 0;
  SharedLibrary shared(path, [&](const auto& snapshot) { objects = snapshot->objects.size(); });
  const ObjectModel cup = shared.change([&](ObjectLibrary& library) {
    const ObjectModel saved =
        library.save(test::random_model(1, "cup"), ObjectLibrary::Existing::kRefuse);
    std::filesystem::rename(path, away);
    return saved;
  });
  EXPECT_EQ(cup.name, "cup");
  EXPECT_NE(shared.fault(), "");
  EXPECT_EQ(objects, 0u);
  std::filesystem::rename(away, path);
  shared.refresh(false);
  EXPECT_EQ(shared.fault(), "");
  EXPECT_EQ(objects, 1u);
}

TEST(SharedLibrary, AStateThatTheListenerHasNotTakenIsHandedOverAgain) {
  test::TemporaryFolder folder;
  std::size_t objects = 0;
  bool fails = false;
  SharedLibrary shared(folder / "library", [&](const auto& snapshot) {
    if (fails) throw std::bad_alloc();
    objects = snapshot->objects.size();
  });
  fails = true;
  shared.change([](ObjectLibrary& library) {
    return library.save(test::random_model(1, "cup"), ObjectLibrary::Existing::kRefuse);
  });
  EXPECT_THROW(shared.refresh(false), std::bad_alloc);
  EXPECT_NE(shared.fault(), "");
  fails = false;
  shared.refresh(false);
  EXPECT_EQ(shared.fault(), "");
  EXPECT_EQ(objects, 1u) << "no file has changed meanwhile";
}

TEST(SharedLibrary, WhatAFailedChangeHasReadIsHandedOver) {
  test::TemporaryFolder folder;
  const std::string path = folder / "library";
  std::size_t objects = 0;
  SharedLibrary shared(path, [&](const auto& snapshot) { objects = snapshot->objects.size(); });
  shared.change([](ObjectLibrary& library) {
    return library.save(test::random_model(1, "cup"), ObjectLibrary::Existing::kRefuse);
  });
  ASSERT_EQ(objects, 1u);
  ObjectLibrary(path).remove("cup");  // by another program
  EXPECT_THROW(shared.change([](ObjectLibrary& library) {
    library.load();
    return library.remove("cup");
  }),
               NameError);
  shared.refresh(false);
  EXPECT_EQ(objects, 0u) << "no file has changed since the failed change has read it";
}

TEST(SharedLibrary, AChangeThatFailsIsReported) {
  test::TemporaryFolder folder;
  SharedLibrary shared(folder / "library", [](const auto&) {});
  EXPECT_THROW(shared.change([](ObjectLibrary& library) { return library.restore("cup"); }),
               NameError);
}

}  // namespace
}  // namespace mbncc::nodelets
