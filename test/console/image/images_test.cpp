// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/images.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc::console {
namespace {

sensor_msgs::Image message(int width, int height, const std::string& encoding, int channels,
                           std::uint8_t value) {
  sensor_msgs::Image message;
  message.width = static_cast<std::uint32_t>(width);
  message.height = static_cast<std::uint32_t>(height);
  message.encoding = encoding;
  message.step = static_cast<std::uint32_t>(width * channels);
  message.data.assign(std::size_t{message.step} * message.height, value);
  return message;
}

TEST(Images, ImagesThatCannotBeShownBecomeEmpty) {
  EXPECT_TRUE(to_rgb({}).empty());
  EXPECT_TRUE(to_rgb(message(4, 4, "32FC7", 3, 0)).empty());
  auto cut = message(4, 4, "bgr8", 3, 0);
  cut.data.resize(5);
  EXPECT_TRUE(to_rgb(cut).empty());
}

TEST(Images, GreyBecomesColour) {
  EXPECT_EQ(to_rgb(message(4, 3, "mono8", 1, 7)).type(), CV_8UC3);
}

TEST(Images, SixteenBitImagesAreScaledByTheWhiteLevel) {
  const auto brightness = [](const char* encoding, int white_level) {
    auto image = message(4, 4, encoding, 2, 0);
    for (std::size_t i = 1; i < image.data.size(); i += 2) image.data[i] = 8;  // 2048 each
    const cv::Mat shown = to_rgb(image, white_level);
    return shown.empty() ? -1 : static_cast<int>(shown.at<cv::Vec3b>(1, 1)[0]);
  };
  for (const char* encoding : {"mono16", "bayer_rggb16"}) {
    EXPECT_EQ(brightness(encoding, 4095), 128) << encoding;
    EXPECT_EQ(brightness(encoding, 0), 8) << encoding;
  }
  EXPECT_EQ(brightness("16UC1", 4095), 128);
  EXPECT_EQ(brightness("16UC1", 0), -1);
}

TEST(Images, LargeImagesAreShrunk) {
  EXPECT_EQ(small(cv::Mat(2048, 2448, CV_8UC3)).cols, 1600);
  EXPECT_EQ(small(cv::Mat(480, 640, CV_8UC3)).cols, 640);
}

TEST(Images, TheCheckerboardIsVisibleOutsideTheMapOnly) {
  const cv::Mat object(20, 20, CV_8UC3, cv::Scalar(10, 20, 30));
  auto map = message(20, 20, "mono8", 1, 0);
  map.data[0] = 255;
  const cv::Mat shown = on_checkerboard(object, map);
  EXPECT_EQ(shown.at<cv::Vec3b>(0, 0), cv::Vec3b(10, 20, 30));
  EXPECT_NE(shown.at<cv::Vec3b>(5, 5), cv::Vec3b(10, 20, 30));
  EXPECT_TRUE(on_checkerboard(object, message(19, 20, "mono8", 1, 0)).empty());
}

TEST(ChangeTint, TintsPixelsThatChangedSinceTheFirstImage) {
  cv::Mat image(60, 80, CV_8UC3, cv::Scalar::all(100));
  ChangeTint tint;
  EXPECT_EQ(cv::norm(tint.tint(image), image, cv::NORM_INF), 0);
  cv::rectangle(image, {20, 20, 20, 20}, cv::Scalar::all(200), cv::FILLED);
  const cv::Mat tinted = tint.tint(image);
  EXPECT_NE(tinted.at<cv::Vec3b>(30, 30), image.at<cv::Vec3b>(30, 30));
  EXPECT_EQ(tinted.at<cv::Vec3b>(5, 5), image.at<cv::Vec3b>(5, 5));
  tint.reset();
  EXPECT_EQ(cv::norm(tint.tint(image), image, cv::NORM_INF), 0);
}

TEST(ChangeTint, AnotherLightIsNoChange) {
  cv::Mat scene(48, 64, CV_8UC3);
  cv::randu(scene, 60, 200);
  ChangeTint tint;
  tint.tint(scene);
  const cv::Mat dim = scene * 0.5;
  EXPECT_EQ(cv::norm(tint.tint(dim), dim, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace mbncc::console
