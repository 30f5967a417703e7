// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/picture_origin.hpp"

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

namespace mbncc::console {
namespace {

sensor_msgs::ImageConstPtr picture(std::uint8_t grey, double stamp) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->data.assign(100, grey);
  image->header.stamp = ros::Time(stamp);
  return image;
}

TEST(PictureOrigin, PicturesThatDifferAreLive) {
  PictureOrigin origin;
  EXPECT_EQ(origin.warning(), "");
  for (int i = 0; i < 20; ++i)
    origin.take(picture(static_cast<std::uint8_t>(i), 100 + i), ros::Time(100 + i));
  EXPECT_EQ(origin.warning(), "");
}

TEST(PictureOrigin, OneThatIsRepeatedIsToldUntilAnotherComes) {
  PictureOrigin origin;
  for (int i = 0; i < PictureOrigin::kEqual; ++i)
    origin.take(picture(7, 100 + i), ros::Time(100 + i));
  EXPECT_EQ(origin.warning(), "") << "it may be chance";
  origin.take(picture(7, 108), ros::Time(108));
  EXPECT_EQ(origin.warning(), "THE SAME PICTURE for 8 s: camera frozen, or a recording");
  origin.take(picture(8, 109), ros::Time(109));
  EXPECT_EQ(origin.warning(), "");
}

TEST(PictureOrigin, OldStampsAreTold) {
  PictureOrigin origin;
  origin.take(picture(1, 100), ros::Time(100 + PictureOrigin::kOld));
  EXPECT_EQ(origin.warning(), "");
  origin.take(picture(2, 100), ros::Time(101 + PictureOrigin::kOld));
  EXPECT_EQ(origin.warning().find("RECORDED "), 0u);
  origin.take(picture(3, 0), ros::Time(500));
  EXPECT_EQ(origin.warning(), "") << "no stamp says nothing";
}

}  // namespace
}  // namespace mbncc::console
