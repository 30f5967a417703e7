// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/library/object_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "library/models.hpp"
#include "mbncc/error.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

TEST(ObjectFile, RoundTripKeepsEverything) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    ObjectModel model = random_model(seed);
    model.revision = seed + 1;
    const ObjectModel read = decode_object(encode_object(model), "/some/where/wrench.png");
    expect_equal(read, model);
    EXPECT_EQ(read.revision, model.revision);
  }
}

TEST(ObjectFile, EncodingIsReproducible) {
  EXPECT_EQ(encode_object(random_model(3)), encode_object(random_model(3)));
}

TEST(ObjectFile, NameIsTheFileNameUpToTheFirstDot) {
  const auto bytes = encode_object(random_model(1));
  EXPECT_EQ(decode_object(bytes, "/lib/.trash/spanner.12.png").name, "spanner");
  EXPECT_THROW(decode_object(bytes, "/lib/2nd try.png"), FileError);
}

TEST(ObjectFile, RefusesModelsThatBreakTheRules) {
  ObjectModel model = random_model(1);
  model.name = "../escape";
  EXPECT_THROW(encode_object(model), std::invalid_argument);
  model = random_model(1);
  model.views.clear();
  EXPECT_THROW(encode_object(model), std::invalid_argument);
  model = random_model(1);
  model.symmetry = 13;
  EXPECT_THROW(encode_object(model), std::invalid_argument);
  model = random_model(1);
  model.views.front().map.setTo(128);
  EXPECT_THROW(encode_object(model), std::invalid_argument);
}

TEST(ObjectFile, RefusesToWriteMorePixelsThanItReads) {
  ObjectModel model = random_model(1);
  View large;
  large.template_image = cv::Mat::zeros(3000, 3000, CV_8UC3);
  large.map = cv::Mat(3000, 3000, CV_8UC1, cv::Scalar(255));
  large.image_size = {3000, 3000};
  model.views = {large};
  EXPECT_THROW(encode_object(model), std::invalid_argument);
}

TEST(ObjectFile, SpecialFilesAreNotRead) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "wrench.png").c_str(), 0644), 0);
  for (const std::string& path : {folder / "wrench.png", std::string("/dev/null")}) {
    try {
      read_object_file(path);
      ADD_FAILURE() << path << " was read";
    } catch (const FileError& error) {
      EXPECT_EQ(error.reason(), "not a regular file");
    }
  }
}

TEST(ObjectFile, ErrorsNameThePath) {
  try {
    decode_object({1, 2, 3}, "/lib/wrench.png");
    FAIL() << "three bytes are no object";
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), "/lib/wrench.png");
    EXPECT_FALSE(error.reason().empty());
  }
}

}  // namespace
}  // namespace mbncc::test
