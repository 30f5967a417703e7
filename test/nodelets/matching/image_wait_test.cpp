// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/image_wait.hpp"

#include <gtest/gtest.h>

#include <future>

namespace mbncc::nodelets {
namespace {

constexpr double kPatience = 30;  // [s] not reached unless a test fails

sensor_msgs::ImageConstPtr stamped(double stamp) {
  const sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->header.stamp = ros::Time(stamp);
  return image;
}

TEST(ImageWait, HandsOverTheImageAfterTheCall) {
  ImageWait wait;
  wait.enter();
  auto call = std::async(std::launch::async, [&] { return wait.next(ros::Time(10), kPatience); });
  wait.offer(stamped(9));
  wait.offer(stamped(10));
  wait.offer(stamped(11));
  const auto image = call.get();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.stamp, ros::Time(11));
  EXPECT_TRUE(wait.wanted());
  wait.leave();
  EXPECT_FALSE(wait.wanted());
}

TEST(ImageWait, KeepsNoImageWhileNobodyWaits) {
  ImageWait wait;
  wait.offer(stamped(11));
  wait.enter();
  EXPECT_FALSE(wait.next(ros::Time(10), 0));
  wait.offer(stamped(11));
  EXPECT_TRUE(wait.next(ros::Time(10), 0));
  wait.leave();
  wait.enter();
  EXPECT_FALSE(wait.next(ros::Time(10), 0));
}

TEST(ImageWait, EndsWhenClosed) {
  ImageWait wait;
  wait.enter();
  auto call = std::async(std::launch::async, [&] { return wait.next(ros::Time(10), kPatience); });
  wait.close();
  EXPECT_FALSE(call.get());
  EXPECT_FALSE(wait.next(ros::Time(10), kPatience));
}

}  // namespace
}  // namespace mbncc::nodelets
