// SPDX-License-Identifier: BSD-3-Clause
// Within one process, images are passed by pointer: every subscriber gets the published image
// itself, including rectified images.
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <string>

#include "nodelets/spin_until.hpp"

namespace mbncc::nodelets {
namespace {

/// Addresses of the received images by stamp.
class Listener {
 public:
  explicit Listener(const std::string& topic)
      : subscriber_(ros::NodeHandle().subscribe<sensor_msgs::Image>(
            topic, 10, [this](const sensor_msgs::ImageConstPtr& image) {
              heard_[image->header.stamp] = image;  // kept, so that the address is not reused
            })) {}

  /// Number of images that both have received, and number of those that were the same object.
  std::pair<int, int> shared_with(const Listener& other) const {
    int both = 0, same = 0;
    for (const auto& [stamp, image] : heard_) {
      const auto there = other.heard_.find(stamp);
      if (there == other.heard_.end()) continue;
      ++both;
      same += there->second == image ? 1 : 0;
    }
    return {both, same};
  }

 private:
  std::map<ros::Time, sensor_msgs::ImageConstPtr> heard_;
  ros::Subscriber subscriber_;
};

TEST(OneProcess, ImagesAreNotCopied) {
  nodelet::Loader loader(false);
  ASSERT_TRUE(loader.load("/camera", "mbncc_vision/SimulatedCameraNodelet", {}, {}));
  ASSERT_TRUE(loader.load("/rectify", "mbncc_vision/RectifyNodelet", {}, {}));
  for (const std::string topic : {"/image_raw", "/image_rect"}) {
    const Listener a(topic), b(topic);
    ASSERT_TRUE(spin_until([&] { return a.shared_with(b).first >= 5; })) << topic;
    const auto [both, same] = a.shared_with(b);
    EXPECT_EQ(both, same) << topic;
  }
}

// Unloads the rectify nodelet and then the camera nodelet, whose timer is hardly ever idle.
TEST(OneProcess, UnloadingDuringCallbacksLeavesNothingBehind) {
  for (int round = 0; round < 20; ++round) {
    int heard = 0;
    const ros::Subscriber listener = ros::NodeHandle().subscribe<sensor_msgs::Image>(
        "/image_rect", 1, [&heard](const sensor_msgs::ImageConstPtr&) { ++heard; });
    nodelet::Loader loader(false);
    ASSERT_TRUE(loader.load("/camera", "mbncc_vision/SimulatedCameraNodelet", {}, {}));
    ASSERT_TRUE(loader.load("/rectify", "mbncc_vision/RectifyNodelet", {}, {}));
    ASSERT_TRUE(spin_until([&heard] { return heard > 0; })) << round;
  }
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "one_process_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
