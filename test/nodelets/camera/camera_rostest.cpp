// SPDX-License-Identifier: BSD-3-Clause
// The camera nodelet, loaded into this process, plays folders and videos that the tests write.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "nodelets/spin_until.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

/// The grey level that fills image `number`.
int grey_of(int number) {
  return 20 + 15 * number;
}

cv::Mat image_of(int number) {
  return cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(grey_of(number)));
}

void write_images(const std::string& folder, int count) {
  std::filesystem::create_directories(folder);
  char name[32];
  for (int i = 0; i < count; ++i) {
    std::snprintf(name, sizeof name, "/%03d.png", i);
    cv::imwrite(folder + name, image_of(i));
  }
}

class Camera : public testing::Test {
 protected:
  Camera() {
    images_ = node_.subscribe<sensor_msgs::Image>(
        "image_raw", 200,
        [this](const sensor_msgs::ImageConstPtr& image) { received_.push_back(image); });
    infos_ = node_.subscribe<sensor_msgs::CameraInfo>(
        "camera_info", 200, [this](const sensor_msgs::CameraInfoConstPtr& info) { info_ = info; });
    log_ = node_.subscribe<rosgraph_msgs::Log>("/rosout", 200,
                                               [this](const rosgraph_msgs::Log::ConstPtr& entry) {
                                                 if (entry->level == rosgraph_msgs::Log::FATAL)
                                                   fatal_ += entry->msg;
                                               });
    diagnostics_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 20, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& report) {
          if (!report->status.empty()) state_ = report->status[0].message;
        });
  }

  ~Camera() override {
    loader_.unload("/camera");
    ros::param::del("/camera");
  }

  template <class Value>
  void set(const std::string& key, const Value& value) {
    ros::param::set("/camera/" + key, value);
  }

  bool load() {
    return loader_.load("/camera", "mbncc_vision/CameraNodelet", ros::names::getRemappings(), {});
  }

  int grey(std::size_t index) const { return received_[index]->data[0]; }

  test::TemporaryFolder folder_;
  ros::NodeHandle node_;
  ros::Subscriber images_, infos_, log_, diagnostics_;
  std::vector<sensor_msgs::ImageConstPtr> received_;
  sensor_msgs::CameraInfoConstPtr info_;
  std::string fatal_, state_;
  nodelet::Loader loader_{false};
};

TEST_F(Camera, PublishesEveryImageOfAFolderInOrder) {
  write_images(folder_ / "images", 12);
  std::ofstream(folder_ / "images/notes.txt") << "not an image";
  set("source", folder_ / "images");
  set("frame_rate", 50.0);
  set("frame_id", std::string("eye"));
  ASSERT_TRUE(load());
  ASSERT_TRUE(
      spin_until([this] { return state_.rfind("finished", 0) == 0 && received_.size() >= 12; }));
  ASSERT_EQ(received_.size(), 12u);
  for (std::size_t i = 0; i < received_.size(); ++i) {
    EXPECT_EQ(grey(i), grey_of(static_cast<int>(i)));
    EXPECT_EQ(received_[i]->header.frame_id, "eye");
    if (i > 0) {
      EXPECT_GT(received_[i]->header.stamp, received_[i - 1]->header.stamp);
    }
  }
  ASSERT_TRUE(info_);
  EXPECT_EQ(info_->header.frame_id, "eye");
  EXPECT_EQ(info_->width, 64u);
  EXPECT_EQ(info_->K[0], 0) << "not calibrated";
}

TEST_F(Camera, LoopsAndSkipsUnreadableImages) {
  write_images(folder_ / "images", 2);
  std::ofstream(folder_ / "images/001a.png") << "rubbish";
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", image_of(2), jpeg);
  std::ofstream(folder_ / "images/001b.jpg", std::ios::binary)
      << std::string(jpeg.begin(), jpeg.end() - 8);
  set("source", folder_ / "images");
  set("frame_rate", 100.0);
  set("loop", true);
  ASSERT_TRUE(load());
  ASSERT_TRUE(spin_until([this] { return received_.size() >= 10; }));
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(grey(i), grey_of(i % 2));
}

TEST_F(Camera, WaitsForAMissingFolder) {
  set("source", folder_ / "later");
  set("frame_rate", 50.0);
  ASSERT_TRUE(load());
  ASSERT_TRUE(spin_until([this] { return state_.find("no such folder") != std::string::npos; }));
  write_images(folder_ / "hidden", 5);
  std::filesystem::rename(folder_ / "hidden", folder_ / "later");
  ASSERT_TRUE(spin_until([this] { return received_.size() >= 5; }));
  EXPECT_EQ(grey(0), grey_of(0));
}

TEST_F(Camera, PlaysAVideo) {
  const std::string path = folder_ / "video.avi";
  {
    cv::VideoWriter writer(path, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           25, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < 8; ++i) writer.write(image_of(i));
  }
  set("source", path);
  ASSERT_TRUE(load());
  ASSERT_TRUE(spin_until([this] { return received_.size() >= 8; }));
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(grey(i), grey_of(i), 4);
}

TEST_F(Camera, PlaysAFolderOfOneImageInALoop) {
  write_images(folder_ / "images", 1);
  set("source", folder_ / "images");
  set("frame_rate", 50.0);
  set("loop", true);
  ASSERT_TRUE(load());
  EXPECT_TRUE(spin_until([this] { return received_.size() >= 8; }));
}

TEST_F(Camera, InvalidParametersStopItWithAnExplanation) {
  const auto refusal = [this](const std::string& key, const auto& value) {
    ros::param::del("/camera");
    fatal_.clear();
    set("source", folder_.path());
    set(key, value);
    EXPECT_FALSE(load()) << key;
    EXPECT_TRUE(spin_until([this] { return !fatal_.empty(); })) << key;
    EXPECT_NE(fatal_.find("'" + key + "'"), std::string::npos) << fatal_;
    return fatal_;
  };
  EXPECT_NE(refusal("frame_rate", 2000.0).find("0 .. 1000 [Hz]"), std::string::npos);
  EXPECT_NE(refusal("frame_rat", 20.0).find("'frame_rate'"), std::string::npos);
  refusal("loop", std::string("yes"));
  refusal("width", 3.5);
  refusal("source", std::string());
  refusal("camera_name", std::string("my camera"));
  refusal("camera_info_url", std::string("ftp://nowhere"));
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "camera_rostest");
  // Between tests, no other handle exists, and the node would shut down.
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
