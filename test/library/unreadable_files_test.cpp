// SPDX-License-Identifier: BSD-3-Clause
// How the library handles unreadable files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "library/file_io.hpp"
#include "library/models.hpp"
#include "library/object_yaml.hpp"
#include "library/png_codec.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

using Existing = ObjectLibrary::Existing;

TEST(ObjectLibrary, UnreadableFilesAreQuarantinedAndTheRestLoads) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  std::ofstream(folder / "broken.png") << "not an image";
  settle(folder / "broken.png");
  std::ofstream(folder / "notes.txt") << "not the library's concern";
  const auto snapshot = library.load();
  ASSERT_EQ(snapshot->objects.size(), 1u);
  EXPECT_EQ(snapshot->objects[0]->name, "wrench");
  ASSERT_EQ(snapshot->quarantined.size(), 1u);
  EXPECT_EQ(snapshot->quarantined[0].file, "broken.png");
  EXPECT_TRUE(snapshot->quarantined[0].moved);
  EXPECT_FALSE(std::filesystem::exists(folder / "broken.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "notes.txt"));
  EXPECT_TRUE(library.load()->quarantined.empty());
  ASSERT_EQ(library.quarantine().size(), 1u);
  EXPECT_EQ(library.quarantine()[0].file, "broken.png");
  EXPECT_EQ(library.quarantine()[0].reason, snapshot->quarantined[0].reason);
}

void write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

// An object file as a later version of this package may write it.
std::vector<std::uint8_t> newer_format(const ObjectModel& model) {
  std::vector<cv::Rect> rectangles;
  const cv::Size size = model.views.front().map.size();
  rectangles.emplace_back(cv::Point(), size);
  std::string text = library::write_description(model, rectangles);
  const std::string format = "format: " + std::to_string(kObjectFileVersion);
  text.replace(text.find(format), format.size(), "format: 77");
  return library::encode_png(cv::Mat(size, CV_8UC4, cv::Scalar::all(255)), "mbncc", text);
}

TEST(ObjectLibrary, FilesOfANewerFormatAreReportedAndKept) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1, "nut"), Existing::kRefuse);
  ObjectModel wrench = random_model(2);
  wrench.views.resize(1);
  const auto bytes = newer_format(wrench);
  write(folder / "wrench.png", bytes);
  const auto snapshot = library.load();
  EXPECT_EQ(snapshot->objects.size(), 1u);
  ASSERT_EQ(snapshot->quarantined.size(), 1u);
  EXPECT_FALSE(snapshot->quarantined[0].moved);
  EXPECT_NE(snapshot->quarantined[0].reason.find("update"), std::string::npos);
  EXPECT_FALSE(library.changed_on_disk());

  EXPECT_THROW(library.save(wrench, Existing::kRefuse), NameError);
  EXPECT_THROW(library.save(wrench, Existing::kReplace), FileError);
  EXPECT_THROW(library.edit("wrench", [](ObjectModel&) {}), FileError);
  EXPECT_THROW(library.remove("wrench"), FileError);
  EXPECT_EQ(library::read_regular_file(folder / "wrench.png", bytes.size()).bytes, bytes);
  EXPECT_TRUE(library.quarantine().empty());
}

std::vector<std::uint8_t> photograph() {
  const cv::Mat image(40, 60, CV_8UC4, cv::Scalar::all(200));
  return library::encode_png(image, "Software", "a camera");
}

TEST(ObjectLibrary, ImagesThatAreNoObjectsStayInPlace) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), Existing::kRefuse);
  const auto photo = photograph();
  for (const char* name : {"photo.png", "IMG 1.edited.png"}) write(folder / name, photo);
  for (int round = 0; round < 2; ++round) {
    const auto snapshot = library.load();
    EXPECT_EQ(snapshot->objects.size(), 1u);
    EXPECT_TRUE(snapshot->quarantined.empty());
    EXPECT_EQ(snapshot->other_images, (std::vector<std::string>{"IMG 1.edited.png", "photo.png"}));
  }
  EXPECT_TRUE(library.quarantine().empty());
  EXPECT_FALSE(library.changed_on_disk());
  EXPECT_EQ(library::read_regular_file(folder / "photo.png", photo.size()).bytes, photo);
}

TEST(ObjectLibrary, ImagesThatAreNoObjectsAreNotReplacedOrMoved) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  library.save(random_model(1, "nut"), Existing::kRefuse);
  const auto photo = photograph();
  write(folder / "wrench.png", photo);
  EXPECT_THROW(library.save(random_model(1), Existing::kRefuse), FileError);
  EXPECT_THROW(library.save(random_model(1), Existing::kReplace), FileError);
  EXPECT_THROW(library.edit("wrench", [](ObjectModel&) {}), FileError);
  EXPECT_THROW(library.remove("wrench"), FileError);
  EXPECT_THROW(library.rename("nut", "wrench", ""), FileError);
  EXPECT_EQ(library::read_regular_file(folder / "wrench.png", photo.size()).bytes, photo);
}

TEST(ObjectLibrary, DamagedImagesAndDamagedObjectsAreQuarantined) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  auto cut = photograph(), flipped = photograph(), object = encode_object(random_model(1));
  cut.resize(cut.size() - 4);
  flipped[flipped.size() / 2] ^= 1;
  object[object.size() / 2] ^= 1;
  write(folder / "cut.png", cut);
  write(folder / "flipped.png", flipped);
  write(folder / "object.png", object);
  // Valid as an image, but its description of an object is wrong.
  write(folder / "claim.png",
        library::encode_png(cv::Mat(9, 9, CV_8UC4, cv::Scalar::all(9)), "mbncc", "format: 1"));
  for (const char* name : {"cut.png", "flipped.png", "object.png", "claim.png"})
    settle(folder / name);
  const auto snapshot = library.load();
  EXPECT_TRUE(snapshot->other_images.empty());
  EXPECT_EQ(library.quarantine().size(), 4u);
}

TEST(ObjectLibrary, ReplacingAnUnreadableFileQuarantinesIt) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  std::ofstream(folder / "wrench.png") << "not an image";
  settle(folder / "wrench.png");
  library.save(random_model(1), Existing::kReplace);
  expect_equal(*library.load()->find("wrench"), random_model(1));
  EXPECT_EQ(library.quarantine().size(), 1u);
}

}  // namespace
}  // namespace mbncc::test
