// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/platform_intrinsics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mbncc/error.hpp"
#include "nodelets/conversion/strong_lens.hpp"

namespace mbncc::nodelets {
namespace {

using sensor_msgs::CameraInfo;

const std::string kRaw = "plumb_bob 1280 960 900.25 910.5 620 470 -0.3 0.1 0.001 -0.002 0";
const std::string kRectified = "rectified 1280 960 800 800 600 500";

CameraInfo camera_info() {
  CameraInfo info = strong_lens();
  info.K = {900.25, 0, 620, 0, 910.5, 470, 0, 0, 1};
  return info;
}

using Change = std::function<void(CameraInfo&)>;

std::string fault_after(const std::string& text, const Change& change) {
  CameraInfo info = camera_info();
  change(info);
  return fault_of_platform_intrinsics(text, info);
}

TEST(PlatformIntrinsics, TheSameCameraHasNoFault) {
  for (const auto& text : {std::string(), kRaw, kRectified})
    EXPECT_EQ(fault_of_platform_intrinsics(text, camera_info()), "") << text;
  EXPECT_EQ(fault_after("equidistant 1280 960 900.25 910.5 620 470 0.02 -0.01 0 0",
                        [](auto& info) {
                          info.distortion_model = "equidistant";
                          info.D = {0.02, -0.01, 0, 0};
                        }),
            "");
  EXPECT_EQ(fault_after("plumb_bob 1280 960 900.25 910.5 620 470", [](auto& i) { i.D.clear(); }),
            "");
}

TEST(PlatformIntrinsics, ARegionAndBinningAreOfTheSameSensor) {
  const auto crop = [](auto& info) {
    info.roi.x_offset = 100;
    info.roi.y_offset = 40;
    info.roi.width = 800;
    info.roi.height = 600;
    info.binning_x = info.binning_y = 2;
  };
  EXPECT_EQ(fault_after(kRaw, crop), "");
  EXPECT_EQ(fault_after(kRectified, crop), "");
}

TEST(PlatformIntrinsics, ASmallMotionOfPixelsIsAccepted) {
  for (const double part : {-0.09, 0.09}) {
    // Without distortion, this lens's pixels move further at the border than in the raw image.
    EXPECT_EQ(fault_after(kRaw, [&](auto& info) { info.K[2] += part / 2; }), "") << part;
    EXPECT_EQ(fault_after(kRectified, [&](auto& info) { info.P[6] += part; }), "") << part;
  }
  for (const double part : {-0.11, 0.11}) {
    EXPECT_NE(fault_after(kRaw, [&](auto& info) { info.K[2] += part; }), "") << part;
    EXPECT_NE(fault_after(kRectified, [&](auto& info) { info.P[6] += part; }), "") << part;
  }
  // Another focal length moves the pixels at the border of the image most.
  EXPECT_EQ(fault_after(kRectified, [](auto& info) { info.P[0] *= 1 + 0.09 / 679; }), "");
  EXPECT_NE(fault_after(kRectified, [](auto& info) { info.P[0] *= 1 + 0.11 / 679; }), "");
}

// A file of camera_calibration has five decimals in K and six in D.
TEST(PlatformIntrinsics, ARoundedCalibrationIsTheSameCamera) {
  EXPECT_EQ(fault_after(kRaw,
                        [](auto& info) {
                          for (double& number : info.K) number += number > 1 ? 5e-6 : 0;
                          for (double& number : info.D) number += 5e-7;
                        }),
            "");
}

TEST(PlatformIntrinsics, AnotherCameraIsNamed) {
  struct Row {
    std::string text;
    Change change;
    const char* words;
  };
  const std::vector<Row> rows{
      {kRaw, [](auto& i) { i.K[0] *= 1.01; }, "differ by up to"},
      {kRaw, [](auto& i) { i.K[4] *= 1.01; }, "differ by up to"},
      {kRaw, [](auto& i) { i.D[0] = -0.31; }, "differ by up to"},
      {kRaw, [](auto& i) { i.D.assign(5, 0); }, "differ by up to"},
      {kRaw,
       [](auto& i) {
         i.D = {-0.9, 0, 0, 0, 0};
       },
       "a ray in one of them only"},
      {kRaw,
       [](auto& i) {
         i.distortion_model = "equidistant";
         i.D = {0, 0, 0, 0};
       },
       "px)"},
      {kRaw,
       [](auto& i) {
         i.width = 640;
         i.height = 480;
         for (double* number : {&i.K[0], &i.K[2], &i.K[4], &i.K[5]}) *number /= 2;
       },
       "for images of 1280 x 960"},
      {kRaw, [](auto& i) { i.K.fill(0); }, "of raw images"},
      {kRaw, [](auto& i) { i.R = {0, -1, 0, 1, 0, 0, 0, 0, 1}; }, "of raw images"},
      {kRectified, [](auto& i) { i.P[0] = i.P[5] = 808; }, "differ by up to"},
      {kRectified, [](auto& i) { i.P.fill(0); }, "of rectified images"}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::string fault = fault_after(rows[row].text, rows[row].change);
    EXPECT_NE(fault.find("another calibration of the camera"), std::string::npos) << row << fault;
    EXPECT_NE(fault.find(rows[row].words), std::string::npos) << row << ": " << fault;
    EXPECT_NE(fault.find("calibrate the platform again"), std::string::npos) << row << fault;
  }
}

TEST(PlatformIntrinsics, OnlyWhatCalibratePlatformWritesIsAllowed) {
  for (const auto& text : {std::string(), kRaw, kRectified})
    EXPECT_NO_THROW(check_platform_intrinsics(text)) << text;
  for (const char* text : {"plumb_bob", "plumb_bob 1280 960 900 910 620",
                           "1280 960 900 910 620 470", "plumb_bob 1280 960 900 910 620 470 wide",
                           "plumb_bob 0 960 900 910 1 1", "plumb_bob 1280,960,900,910,620,470"})
    EXPECT_THROW(check_platform_intrinsics(text), ConfigError) << text;
}

}  // namespace
}  // namespace mbncc::nodelets
