// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_origin.hpp"

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

namespace mbncc::console {
namespace {

sensor_msgs::ImageConstPtr image(std::uint8_t grey, double stamp) {
  auto message = boost::make_shared<sensor_msgs::Image>();
  message->data.assign(100, grey);
  message->header.stamp = ros::Time(stamp);
  return message;
}

TEST(ImageOrigin, ImagesThatDifferAreLive) {
  ImageOrigin origin;
  EXPECT_EQ(origin.warning(), "");
  for (int i = 0; i < 20; ++i)
    origin.take(image(static_cast<std::uint8_t>(i), 100 + i), ros::Time(100 + i));
  EXPECT_EQ(origin.warning(), "");
}

TEST(ImageOrigin, ARepeatedImageIsReportedUntilAnotherOneArrives) {
  ImageOrigin origin;
  for (int i = 0; i < ImageOrigin::kEqual; ++i) origin.take(image(7, 100 + i), ros::Time(100 + i));
  EXPECT_EQ(origin.warning(), "") << "it may be chance";
  origin.take(image(7, 108), ros::Time(108));
  EXPECT_EQ(origin.warning(), "THE SAME IMAGE for 8 s: camera frozen, or a recording");
  origin.take(image(8, 109), ros::Time(109));
  EXPECT_EQ(origin.warning(), "");
}

TEST(ImageOrigin, OldStampsAreReported) {
  ImageOrigin origin;
  origin.take(image(1, 100), ros::Time(100 + ImageOrigin::kOld));
  EXPECT_EQ(origin.warning(), "");
  origin.take(image(2, 100), ros::Time(101 + ImageOrigin::kOld));
  EXPECT_EQ(origin.warning().find("RECORDED "), 0u);
  origin.take(image(3, 0), ros::Time(500));
  EXPECT_EQ(origin.warning(), "") << "no stamp says nothing";
}

}  // namespace
}  // namespace mbncc::console
