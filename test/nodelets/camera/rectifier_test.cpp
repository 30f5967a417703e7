// SPDX-License-Identifier: BSD-3-Clause
// Rectified images and top views: for which camera and in which frame.
#include "nodelets/camera/rectifier.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mbncc/sim/scene.hpp"
#include "nodelets/camera/rectified_view.hpp"
#include "nodelets/camera/simulated_optics.hpp"

namespace mbncc::nodelets {
namespace {

const cv::Size kSize(320, 240);

SimulatedCameraConfig distorted_cell() {
  SimulatedCameraConfig config;
  config.width = kSize.width;
  config.height = kSize.height;
  config.focal_length = 225;
  config.distortion = -0.3;
  config.principal_x = 20;
  config.principal_y = -15;
  return config;
}

cv::Mat drawing() {
  sim::SceneConfig config;
  config.size = kSize;
  return sim::Scene(config).render({{{3, 80, 1.6}, {180, 130, 0.4}}});
}

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "camera";
  return header;
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  return cv::mean(difference)[1];
}

TEST(Rectifier, RestoresTheUndistortedImage) {
  const SimulatedOptics optics(distorted_cell());
  const cv::Mat straight = drawing(), raw = optics.expose(straight);
  const RectifiedView view = without_distortion(optics.camera_info(), header(), kSize);
  ASSERT_TRUE(view) << view.fault;
  EXPECT_EQ(view.frame_id, "camera");
  const cv::Mat rectified = Rectifier().rectify(raw, view.lens, view.wanted);
  const cv::Rect inner(60, 40, 200, 160);
  EXPECT_LT(mean_difference(rectified(inner), straight(inner)), 3);
  EXPECT_GT(mean_difference(raw(inner), straight(inner)), 5) << "the lens shows";
}

TEST(Rectifier, RestoresTheDrawingFromATiltedCamera) {
  SimulatedCameraConfig config = distorted_cell();
  config.tilt = 8;
  const SimulatedOptics optics(config);
  const cv::Mat straight = drawing(), raw = optics.expose(straight);
  const Lens lens = lens_of(optics.camera_info());
  const TurnedCamera upright{optics.rotation(), optics.pinhole()};
  Rectifier rectifier;
  const cv::Mat rectified = rectifier.rectify(raw, lens, upright);
  const cv::Rect inner(60, 70, 200, 120);
  EXPECT_LT(mean_difference(rectified(inner), straight(inner)), 3);
  EXPECT_GT(mean_difference(raw(inner), straight(inner)), 5) << "the tilt shows";
  const cv::Mat tilted = rectifier.rectify(raw, lens, {cv::Matx33d::eye(), optics.pinhole()});
  EXPECT_GT(mean_difference(tilted(inner), straight(inner)), 5) << "another camera is wanted";
}

/// A part of the raw image must give the corresponding part of the rectified image.
void expect_same_part(const sensor_msgs::CameraInfo& whole) {
  const cv::Mat raw = drawing();
  const cv::Rect part(40, 30, 200, 160), inner(30, 30, 140, 100);
  auto info = whole;
  info.roi.x_offset = 40;
  info.roi.y_offset = 30;
  info.roi.width = 200;
  info.roi.height = 160;
  Rectifier rectifier;
  const RectifiedView of_whole = without_distortion(whole, header(), kSize);
  const RectifiedView of_part = without_distortion(info, header(), part.size());
  ASSERT_TRUE(of_whole && of_part) << of_whole.fault << of_part.fault;
  const cv::Mat image = rectifier.rectify(raw, of_whole.lens, of_whole.wanted);
  const cv::Mat image_of_part = rectifier.rectify(raw(part).clone(), of_part.lens, of_part.wanted);
  cv::Mat difference;
  cv::absdiff(image(part)(inner), image_of_part(inner), difference);
  EXPECT_LT(cv::norm(difference, cv::NORM_INF), 2);
}

TEST(Rectifier, APartOfTheSensorGivesAPartOfTheImage) {
  auto info = SimulatedOptics(distorted_cell()).camera_info();
  expect_same_part(info);
  info.R = {std::cos(0.03), -std::sin(0.03), 0, std::sin(0.03), std::cos(0.03), 0, 0, 0, 1};
  expect_same_part(info);
  info.distortion_model = "equidistant";
  info.D = {0.02, -0.01, 0, 0};
  expect_same_part(info);
}

TEST(Rectifier, RefusesACalibrationOfAnotherSizeOrAMissingOne) {
  const auto info = SimulatedOptics(distorted_cell()).camera_info();
  EXPECT_FALSE(without_distortion(info, header(), {640, 480}));
  EXPECT_FALSE(without_distortion({}, header(), kSize));
}

}  // namespace
}  // namespace mbncc::nodelets
