// SPDX-License-Identifier: BSD-3-Clause
// Files that are not objects: damaged, hostile, or not regular files.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "library/models.hpp"
#include "library/object_yaml.hpp"
#include "library/png_codec.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/sanitizers.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMemoryBound = std::size_t{64} << 20;

bool is_refused(const Bytes& bytes) {
  try {
    decode_object(bytes, "/library/wrench.png");
    return false;
  } catch (const FileError&) {
    return true;
  }
}

Bytes small_object() {
  return encode_object(random_model(1, "wrench", 20));
}

TEST(HostileFiles, EveryTruncationIsRefused) {
  const Bytes bytes = small_object();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_TRUE(is_refused(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(length))))
        << length;
}

TEST(HostileFiles, EveryFlippedBitIsDetected) {
  const Bytes bytes = encode_object(random_model(1, "wrench", 6));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes mutant = bytes;
    mutant[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    EXPECT_TRUE(is_refused(mutant)) << "byte " << bit / 8 << ", bit " << bit % 8;
  }
}

TEST(HostileFiles, AppendedRemovedAndShuffledBytesAreRefused) {
  std::mt19937 random(7);
  const Bytes bytes = small_object();
  const auto anywhere = [&] {
    return static_cast<long>(
        std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random));
  };
  for (int round = 0; round < 300; ++round) {
    Bytes longer = bytes, shorter = bytes, shuffled = bytes;
    longer.insert(longer.begin() + anywhere(), static_cast<std::uint8_t>(random()));
    shorter.erase(shorter.begin() + anywhere());
    const long first = anywhere(), second = anywhere();
    std::swap_ranges(
        shuffled.begin() + std::min(first, second),
        shuffled.begin() + std::min({std::max(first, second), std::min(first, second) + 40,
                                     static_cast<long>(bytes.size()) - 40}),
        shuffled.end() - 40);
    EXPECT_TRUE(is_refused(longer));
    EXPECT_TRUE(is_refused(shorter));
    EXPECT_TRUE(shuffled == bytes || is_refused(shuffled));
  }
}

// A valid PNG with any description.
Bytes with_description(const std::string& text) {
  cv::Mat rgba(6, 5, CV_8UC4, cv::Scalar::all(255));
  return library::encode_png(rgba, "mbncc", text);
}

std::string sound_description() {
  View view;
  view.template_image = cv::Mat::zeros(6, 5, CV_8UC3);
  view.map = cv::Mat(6, 5, CV_8UC1, cv::Scalar(255));
  view.image_size = {640, 480};
  ObjectModel model;
  model.name = model.label = "wrench";
  model.views = {view};
  return library::write_description(model, {{0, 0, 5, 6}});
}

TEST(HostileFiles, DescriptionsAreChecked) {
  const std::string sound = sound_description();
  ASSERT_FALSE(is_refused(with_description(sound)));
  const auto replaced = [&sound](const std::string& what, const std::string& by) {
    std::string text = sound;
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what << " in\n" << sound;
    return text.replace(at, what.size(), by);
  };
  const std::vector<std::string> texts = {
      "",
      "no mapping",
      "[1, 2]",
      "format: 1",
      "\x01\x02",
      replaced("format: 1", "format: 2"),
      replaced("format: 1", "format: -1"),
      replaced("format: 1", "format: one"),
      replaced("revision: 1", "revision: 0"),
      replaced("revision: 1", "revision: 1e99"),
      replaced("revision: 1", "revision: [1]"),
      replaced("learned_at: 0", "learned_at: 5e9"),
      replaced("enabled: true", "enabled: perhaps"),
      replaced("object_height: 0", "object_height: -1"),
      replaced("object_height: 0", "object_height: nan"),
      replaced("object_height: 0", "object_height: .inf"),
      replaced("[0, 0, 5, 6]", "[0, 0, 5, 5]"),
      replaced("[0, 0, 5, 6]", "[0, 0, 6, 6]"),
      replaced("[0, 0, 5, 6]", "[1, 0, 4, 6]"),
      replaced("[0, 0, 5, 6]", "[0, 0, 5, 1000000]"),
      replaced("[0, 0, 5, 6]", "[0, 0, 5, -6]"),
      replaced("[0, 0, 5, 6]", "[0, 0, 5]"),
      replaced("[0, 0, 5, 6]", "[0, 0, 5, 99999999999]"),
      replaced("[640, 480]", "[4, 4]"),
      replaced("[640, 480]", "[0, 0]"),
      replaced("[640, 480]", "[1000000, 1000000]"),
      replaced("[640, 480]", "[16385, 480]"),
      replaced("[640, 480]", "[16384, 16384]"),
      replaced("object_height: 0", "object_height: 1000000000"),
      replaced("label: \"wrench\"", "label: \"\\u202Ewrench\""),
      replaced("label: \"wrench\"", "label: \"\\x9Bwrench\""),
      replaced("label: \"wrench\"", "label: &w \"wrench\"\nsecond: *w"),
      replaced("GOOD", "EXCELLENT"),
      replaced("views:", "sights:"),
      "format: " + std::string(30000, '['),
      "format: " + std::string(30000, '{'),
      std::string(20000, '-'),
      "a: &a [*a, *a]\nformat: *a",
  };
  for (const auto& text : texts)
    EXPECT_TRUE(is_refused(with_description(text))) << text.substr(0, 300);
}

// Files of earlier versions have no symmetry. "auto" is accepted, but never written.
TEST(HostileFiles, ADeclaredSymmetryIsOptionalAndChecked) {
  const std::string sound = sound_description();
  ASSERT_EQ(sound.find("\nsymmetry:"), std::string::npos);
  const auto read = [](const std::string& text) {
    return decode_object(with_description(text), "/library/wrench.png").symmetry;
  };
  EXPECT_EQ(read(sound), std::nullopt);
  EXPECT_EQ(read("symmetry: auto\n" + sound), std::nullopt);
  EXPECT_EQ(read("symmetry: round\n" + sound), 0);
  EXPECT_EQ(read("symmetry: \"2\"\n" + sound), 2);
  for (const char* wrong : {"13", "0", "-2", "Round", "[2]", "{}", "\"\"", "~"}) {
    try {
      read("symmetry: " + std::string(wrong) + "\n" + sound);
      ADD_FAILURE() << wrong << " was taken";
    } catch (const FileError& error) {
      EXPECT_FALSE(error.reason().empty());
    }
  }
  try {
    read("symmetry: 13\n" + sound);
  } catch (const FileError& error) {
    EXPECT_NE(error.reason().find("'13' is not known; give auto, none, 2 to 12, or round"),
              std::string::npos)
        << error.reason();
  }
}

TEST(HostileFiles, ImagesOfOtherKindsAreRefused) {
  const std::string text = sound_description();
  EXPECT_TRUE(
      is_refused(library::encode_png(cv::Mat(6, 5, CV_8UC4, cv::Scalar::all(255)), "other", text)));
  // Half-transparent pixels are neither map nor background.
  EXPECT_TRUE(
      is_refused(library::encode_png(cv::Mat(6, 5, CV_8UC4, cv::Scalar::all(128)), "mbncc", text)));
  EXPECT_TRUE(
      is_refused(library::encode_png(cv::Mat(6, 5, CV_8UC4, cv::Scalar::all(0)), "mbncc", text)));
}

std::uint32_t crc_of(const Bytes& bytes, std::size_t from, std::size_t to) {
  std::uint32_t crc = ~0u;
  for (std::size_t i = from; i < to; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1)));
  }
  return ~crc;
}

void put_number(Bytes& bytes, std::size_t at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i)
    bytes[at + static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

// A valid object whose header claims another size, with a correct checksum.
Bytes claiming_size(std::uint32_t width, std::uint32_t height) {
  Bytes bytes = small_object();
  put_number(bytes, 16, width);
  put_number(bytes, 20, height);
  put_number(bytes, 29, crc_of(bytes, 12, 29));
  return bytes;
}

std::size_t peak_memory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

// Runs in a child process, whose peak memory does not depend on earlier tests.
bool is_refused_within_memory_bound(const Bytes& bytes) {
  const pid_t child = ::fork();
  if (child == 0) {
    const std::size_t before = peak_memory();
    bool refused = false;
    try {
      decode_object(bytes, "/library/wrench.png");
    } catch (const FileError&) {
      refused = true;
    }
    const bool bounded = kSanitized || peak_memory() - before <= kMemoryBound;
    ::_exit(refused && bounded ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// 64 kB of text that expand to 300 MB.
TEST(HostileFiles, AliasesAreRefusedBeforeTheyAreExpanded) {
  std::string text = sound_description();
  const std::string advice = "advice:\n    []";
  const auto at = text.find(advice);
  ASSERT_NE(at, std::string::npos) << text;
  std::string bomb = "advice: [&a " + std::string(32000, 'a');
  while (text.size() + bomb.size() < library::PngLimits::kMaxText - 100) bomb += ",*a";
  text.replace(at, advice.size(), bomb + "]");
  EXPECT_TRUE(is_refused_within_memory_bound(with_description(text)));
  try {
    decode_object(with_description(text), "/library/wrench.png");
  } catch (const FileError& error) {
    EXPECT_NE(error.reason().find("aliases"), std::string::npos) << error.reason();
  }
}

TEST(HostileFiles, DecompressionBombsStayWithinTheMemoryBound) {
  EXPECT_TRUE(is_refused_within_memory_bound(claiming_size(0x7fffffff, 0x7fffffff)));
  EXPECT_TRUE(is_refused_within_memory_bound(claiming_size(60000, 60000)));
  EXPECT_TRUE(is_refused_within_memory_bound(claiming_size(8192, 1024)));
  EXPECT_TRUE(is_refused_within_memory_bound(claiming_size(0, 10)));
  // The largest accepted image, fully transparent: it is not an object, and a few kilobytes claim
  // 32 MB.
  std::string text = sound_description();
  text.replace(text.find("[0, 0, 5, 6]"), 12, "[0, 0, 2896, 2896]");
  text.replace(text.find("[640, 480]"), 10, "[3000, 3000]");
  const Bytes bomb = library::encode_png(cv::Mat::zeros(2896, 2896, CV_8UC4), "mbncc", text);
  EXPECT_LT(bomb.size(), 100000u);
  EXPECT_TRUE(is_refused_within_memory_bound(bomb));
}

TEST(HostileFiles, SpecialFilesAreQuarantined) {
  TemporaryFolder folder, elsewhere;
  ObjectLibrary library(folder.path());
  library.save(random_model(1), ObjectLibrary::Existing::kRefuse);
  ObjectLibrary(elsewhere.path()).save(random_model(2), ObjectLibrary::Existing::kRefuse);
  ASSERT_EQ(::mkfifo((folder / "fifo.png").c_str(), 0644), 0);
  std::filesystem::create_directory(folder / "folder.png");
  std::filesystem::create_symlink(elsewhere / "wrench.png", folder / "link.png");
  std::filesystem::create_symlink("loop.png", folder / "loop.png");
  std::ofstream(folder / "empty.png");
  std::ofstream(folder / "bad name!.png") << "x";
  std::ofstream(folder / "sparse.png") << "x";
  std::filesystem::resize_file(folder / "sparse.png", std::uintmax_t{1} << 40);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    settle(entry.path().string());
  const auto snapshot = library.load();
  EXPECT_EQ(snapshot->objects.size(), 1u);
  EXPECT_EQ(snapshot->quarantined.size(), 7u);
  for (const auto& file : snapshot->quarantined) EXPECT_TRUE(file.moved) << file.file;
  EXPECT_EQ(library.quarantine().size(), 7u);
  EXPECT_TRUE(std::filesystem::exists(elsewhere / "wrench.png"))
      << "the link moved, not its target";
}

TEST(HostileFiles, QuarantineKeepsFilesOfOneNameApart) {
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  for (const char* content : {"first", "second"}) {
    std::ofstream(folder / "wrench.png") << content;
    settle(folder / "wrench.png");
    library.load();
  }
  EXPECT_EQ(library.quarantine().size(), 2u);
}

}  // namespace
}  // namespace mbncc::test
