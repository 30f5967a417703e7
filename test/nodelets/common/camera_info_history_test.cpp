// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/camera_info_history.hpp"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <limits>

namespace mbncc::nodelets {
namespace {

const cv::Size kSize(640, 480);

class CameraInfoHistoryTest : public testing::Test {
 protected:
  void receive(double stamp, double focal_length, const std::string& frame = "camera") {
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->header.stamp.fromSec(stamp);
    info->header.frame_id = frame;
    info->width = kSize.width;
    info->height = kSize.height;
    info->K[0] = focal_length;
    history_.add(info, now_);
  }

  /// Focal length for an image stamped `stamp`; 0 if there is no calibration.
  double of_image(double stamp, cv::Size size = kSize) {
    std_msgs::Header header;
    header.stamp.fromSec(stamp);
    header.frame_id = "camera";
    const auto info = history_.of_image(header, size, now_);
    return info ? info->K[0] : 0;
  }

  CameraInfoHistory history_{60};
  CameraInfoHistory::Clock::time_point now_ = CameraInfoHistory::Clock::now();
};

TEST_F(CameraInfoHistoryTest, AnImageGetsTheCalibrationWithItsStamp) {
  for (int i = 1; i <= 5; ++i) receive(i, 100 * i);
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(of_image(i), 100 * i);
}

TEST_F(CameraInfoHistoryTest, WithoutItsStampTheNeighboursMustBeEqual) {
  receive(1, 500);
  EXPECT_EQ(of_image(0.5), 500);
  EXPECT_EQ(of_image(9), 500);
  receive(2, 500);
  receive(3, 700);
  receive(4, 700);
  EXPECT_EQ(of_image(1.5), 500) << "an image that was searched late";
  EXPECT_EQ(of_image(2.5), 0) << "the lens was changed at about its stamp";
  EXPECT_EQ(of_image(3.5), 0) << "the next image may differ as well";
  EXPECT_EQ(of_image(4.5), 700);
}

TEST_F(CameraInfoHistoryTest, AnImageThatShouldHaveItsOwnCalibrationGetsNoOtherForASecond) {
  for (int i = 1; i <= 3; ++i) {
    EXPECT_FALSE(history_.is_awaited(ros::Time(i))) << "not known to come with the images";
    receive(i, 500);
    EXPECT_EQ(of_image(i), 500);
    EXPECT_EQ(of_image(i), 500) << "another caller";
  }
  EXPECT_TRUE(history_.is_awaited(ros::Time(4)));
  EXPECT_FALSE(history_.is_awaited(ros::Time(3)));
  EXPECT_EQ(of_image(0.5), 500) << "an older image, given with a goal";
  for (const double stamp : {4., 4., 5.}) EXPECT_EQ(of_image(stamp), 0) << "it may have changed";
  now_ += std::chrono::seconds(2);
  EXPECT_EQ(of_image(6), 500) << "they no longer come with the images";
  EXPECT_FALSE(history_.is_awaited(ros::Time(7)));
}

TEST_F(CameraInfoHistoryTest, ACalibrationOfEverySecondImageSuffices) {
  for (int i = 1; i <= 20; ++i) {
    if (i % 2 == 1) receive(i, 500);
    EXPECT_EQ(of_image(i), 500) << i;
  }
}

TEST_F(CameraInfoHistoryTest, ANewCalibrationThatIsPublishedOnceIsInForceAfterTwoSeconds) {
  receive(1, 500);
  receive(2, 700);
  EXPECT_EQ(of_image(3), 0);
  now_ += std::chrono::seconds(3);
  EXPECT_EQ(of_image(6), 700);
}

TEST_F(CameraInfoHistoryTest, AStampThatWasConvertedToDoubleIsTheSame) {
  const double stamp = 1795865050.458667190;
  receive(stamp, 500);
  receive(stamp + 0.033, 700);
  EXPECT_EQ(of_image(stamp + 4e-7), 500);
}

TEST_F(CameraInfoHistoryTest, ACalibrationWithNanIsEqualToItself) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  receive(1, nan);
  receive(2, nan);
  EXPECT_NE(of_image(1.5), 0) << "found, so that its fault can be reported";
}

TEST_F(CameraInfoHistoryTest, OtherFramesAndSizesDoNotCount) {
  receive(1, 500);
  receive(2, 700, "other_camera");
  EXPECT_EQ(of_image(2), 500);
  EXPECT_EQ(of_image(2, {320, 240}), 0);
}

TEST_F(CameraInfoHistoryTest, AClockThatIsSetBackDiscardsEarlierCalibrations) {
  for (int i = 100; i < 110; ++i) receive(i, 500);
  receive(42, 700);
  EXPECT_EQ(of_image(42.5), 700);
  EXPECT_EQ(of_image(42), 700);
  receive(41.98, 700, "other");
  EXPECT_EQ(of_image(42.5), 700) << "slightly out of order";
}

TEST_F(CameraInfoHistoryTest, AnImageIsNotMeasuredWithALateCalibration) {
  for (int i = 1; i <= 4; ++i) {
    receive(i, 700);
    of_image(i);
  }
  receive(5, 700);
  receive(4.9, 500);
  EXPECT_EQ(of_image(5), 0) << "its own calibration was discarded";
  receive(5.2, 700, "other");
  receive(5.1, 500);
  EXPECT_EQ(of_image(5.1), 500) << "those of other frames do not count";
}

TEST_F(CameraInfoHistoryTest, ACalibrationExpires) {
  receive(1, 500);
  EXPECT_TRUE(history_.newest(now_));
  now_ += std::chrono::seconds(61);
  EXPECT_FALSE(history_.newest(now_));
  EXPECT_EQ(of_image(1), 0);
  receive(2, 700);
  EXPECT_EQ(of_image(1.5), 700) << "the expired one is no neighbour";
  history_.clear();
  EXPECT_FALSE(history_.newest(now_));
}

}  // namespace
}  // namespace mbncc::nodelets
