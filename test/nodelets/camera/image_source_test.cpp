// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/image_source.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "mbncc/error.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

class FolderOfImages : public testing::Test {
 protected:
  void write(const std::string& name, int grey) {
    cv::imwrite(folder_ / name, cv::Mat(8, 9, CV_8UC3, cv::Scalar::all(grey)));
  }

  std::unique_ptr<ImageSource> open(bool loop = false) {
    CameraConfig config;
    config.source = folder_.path();
    config.loop = loop;
    std::vector<std::string> refused;
    return open_image_source(config, refused);
  }

  test::TemporaryFolder folder_;
};

/// The message with which a source is refused; "" if it opens.
std::string refusal(const std::string& source) {
  CameraConfig config;
  config.source = source;
  std::vector<std::string> refused;
  try {
    open_image_source(config, refused);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

int next_grey(ImageSource& source) {
  return source.grab() ? source.retrieve().at<cv::Vec3b>(0, 0)[0] : -1;
}

TEST_F(FolderOfImages, PlaysInTheOrderOfNamesAndEnds) {
  write("b.png", 20);
  write("a.png", 10);
  write("c.JPG", 30);
  const auto source = open();
  EXPECT_FALSE(source->is_live());
  EXPECT_EQ(next_grey(*source), 10);
  EXPECT_EQ(next_grey(*source), 20);
  EXPECT_NEAR(next_grey(*source), 30, 2);
  EXPECT_FALSE(source->grab());
  EXPECT_FALSE(source->grab());
}

TEST_F(FolderOfImages, LoopIncludesImagesAddedMeanwhile) {
  write("a.png", 10);
  const auto source = open(true);
  EXPECT_EQ(next_grey(*source), 10);
  write("b.png", 20);
  EXPECT_EQ(next_grey(*source), 10);
  EXPECT_EQ(next_grey(*source), 20);
  EXPECT_EQ(next_grey(*source), 10);
}

TEST_F(FolderOfImages, LoopOverAFolderThatWasEmptiedEnds) {
  write("a.png", 10);
  const auto source = open(true);
  EXPECT_EQ(next_grey(*source), 10);
  std::filesystem::remove(folder_ / "a.png");
  EXPECT_FALSE(source->grab());
}

TEST_F(FolderOfImages, UnreadableImageIsNamedAndTheNextOnePlays) {
  std::ofstream(folder_ / "a.png") << "rubbish";
  write("b.png", 20);
  const auto source = open();
  ASSERT_TRUE(source->grab());
  try {
    source->retrieve();
    FAIL() << "rubbish was read";
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), folder_ / "a.png");
  }
  EXPECT_EQ(next_grey(*source), 20);
}

TEST_F(FolderOfImages, WithoutImagesIsRefused) {
  std::ofstream(folder_ / "notes.txt") << "text";
  EXPECT_NE(refusal(folder_.path()).find("contains no image"), std::string::npos);
}

TEST_F(FolderOfImages, AFileThatIsNoVideoIsRefused) {
  std::ofstream(folder_ / "video.avi") << "rubbish";
  EXPECT_NE(refusal(folder_ / "video.avi").find("not a readable video"), std::string::npos);
}

TEST(ImageSource, MissingSourcesAreRefused) {
  EXPECT_NE(refusal("/no/such/folder").find("no such folder"), std::string::npos);
  EXPECT_NE(refusal("/dev/no_such_video").find("no such folder"), std::string::npos);
  EXPECT_NE(refusal("/dev/no_such_video").find("there is "), std::string::npos);
  EXPECT_NE(refusal("99999").find("does not answer"), std::string::npos);
}

TEST(ImageSource, PasswordsAreRemovedFromStreamNames) {
  const std::string secrets[][2] = {
      {"rtsp://admin:secret@10.0.0.7:554/live", "rtsp://10.0.0.7:554/live"},
      {"rtsp://admin:se/c@ret?#:@camera/live", "rtsp://camera/live"},
      {"http://camera/video?user=admin&password=secret", "http://camera/video?..."},
      {"http://admin:secret@camera?token=secret", "http://camera?..."},
      {"rtsp:/admin:secret@camera/live", "rtsp:camera/live"},
      {"rtspsrc location=rtsp://camera user-id=admin user-pw=secret ! appsink", "rtspsrc ..."},
      {"rtspsrc user-pw=secret ! appsink", "rtspsrc ..."},
      {"rtsp://admin:secret@camera/live ", "rtsp ..."}};
  for (const auto& [source, told] : secrets) EXPECT_EQ(without_secrets(source), told);
  for (const std::string harmless :
       {"0", "/dev/video0", "/data/a day/of images", "rtsp://camera/1"})
    EXPECT_EQ(without_secrets(harmless), harmless);
}

TEST(ImageSource, PasswordsDoNotReachMessagesOrStandardError) {
  for (const std::string source :
       {"http://admin:secret@127.0.0.1:1/live", "rtsp://admin:secret@127.0.0.1:1/live",
        "http://127.0.0.1:1/video?password=secret", "rtsp:/admin:secret@127.0.0.1:1"}) {
    testing::internal::CaptureStderr();
    const std::string sentence = refusal(source);
    const std::string written = testing::internal::GetCapturedStderr();
    EXPECT_FALSE(sentence.empty()) << source;
    EXPECT_EQ(sentence.find("secret"), std::string::npos) << sentence;
    EXPECT_EQ(written.find("secret"), std::string::npos) << written;
  }
}

}  // namespace
}  // namespace mbncc::nodelets
