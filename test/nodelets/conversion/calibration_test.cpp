// SPDX-License-Identifier: BSD-3-Clause
// From camera_info and tf to metres: raw and rectified images, and invalid calibrations.
#include "nodelets/conversion/calibration.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "mbncc/sim/scene.hpp"
#include "nodelets/camera/simulated_optics.hpp"
#include "nodelets/conversion/camera_model.hpp"
#include "nodelets/conversion/rays.hpp"
#include "nodelets/conversion/strong_lens.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const cv::Size kSize(1280, 960);

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(10);
  return header;
}

/// The platform faces the camera at a distance of `z` [m].
geometry_msgs::TransformStamped platform_at(double z) {
  geometry_msgs::TransformStamped transform;
  transform.header = header();
  transform.child_frame_id = "platform";
  transform.transform.translation.z = z;
  transform.transform.rotation.w = 1;
  return transform;
}

PlatformConfig at_distance(bool rectified) {
  PlatformConfig config;
  config.platform_distance = 0.8;
  config.rectified = rectified;
  return config;
}

/// The pixel of a point [m] in the raw image.
cv::Point2d project(const cv::Vec3d& point, const sensor_msgs::CameraInfo& info) {
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{cv::Point3d(point)}, cv::Vec3d(), cv::Vec3d(),
                    cv::Matx33d(info.K.data()), info.D, pixels);
  return pixels[0];
}

TEST(Rays, OfRawPixelsUndoTheLens) {
  const auto info = strong_lens();
  const auto rays = rays_of(info, false, kSize);
  ASSERT_TRUE(rays);
  for (double x = -0.45; x <= 0.45; x += 0.15)
    for (double y = -0.35; y <= 0.35; y += 0.1) {
      const cv::Vec3d point(x, y, 0.8);
      const cv::Vec3d ray = (*rays)(project(point, info));
      EXPECT_LT(cv::norm(ray * (0.8 / ray[2]) - point), 1e-6) << x << " " << y;
    }
}

TEST(Rays, AreNotFiniteWhereTheLensModelFoldsOver) {
  auto info = strong_lens();
  info.D = {-0.9, 0, 0, 0, 0};
  const auto rays = rays_of(info, false, kSize);
  ASSERT_TRUE(rays);
  EXPECT_TRUE(std::isnan((*rays)({1279, 0})[0]));
  EXPECT_FALSE(std::isnan((*rays)({580, 530})[0]));
}

// Beyond the fold the radius rises again, so that a ray leads there, but it is not one that the
// lens can form.
TEST(Rays, AreNotFiniteBehindAFold) {
  auto info = strong_lens();
  info.distortion_model = "equidistant";
  info.D = {-1, 0.4, 0, 0};
  const auto rays = rays_of(info, false, kSize);
  ASSERT_TRUE(rays);
  EXPECT_FALSE(std::isnan((*rays)({580 + 900 * 0.3, 530})[0]));
  EXPECT_TRUE(std::isnan((*rays)({580 + 900 * 0.45, 530})[0]));

  auto radial = strong_lens();
  radial.D = {-1.36, 0.6, 0, 0, 0.25};
  const auto radial_rays = rays_of(radial, false, kSize);
  ASSERT_TRUE(radial_rays);
  EXPECT_FALSE(std::isnan((*radial_rays)({560, 500})[0]));
  EXPECT_TRUE(std::isnan((*radial_rays)({263, 405})[0]));
}

TEST(Calibration, RawAndRectifiedImagesGiveTheSameMetres) {
  const auto info = strong_lens();
  tf2_ros::Buffer tf;
  const auto raw = calibrate(at_distance(false), &info, header(), kSize, tf);
  const auto rectified = calibrate(at_distance(true), &info, header(), kSize, tf);
  ASSERT_TRUE(raw.platform && rectified.platform) << raw.fault << rectified.fault;
  for (const double height : {0.0, 0.03, 0.06}) {
    const cv::Vec3d point(0.12, -0.2, 0.8 - height);
    const cv::Point2d in_raw = project(point, info);
    const cv::Point2d in_rectified(800 * point[0] / point[2] + 600,
                                   800 * point[1] / point[2] + 500);
    const auto a = raw.platform->lift({in_raw.x, in_raw.y, 0}, {}, height);
    const auto b = rectified.platform->lift({in_rectified.x, in_rectified.y, 0}, {}, height);
    ASSERT_TRUE(a && b);
    EXPECT_LT(cv::norm(a->position - point), 1e-6);
    EXPECT_LT(cv::norm(b->position - point), 1e-9);
  }
}

TEST(Rays, OfAFisheyeUndoTheLens) {
  auto info = strong_lens();
  info.distortion_model = "equidistant";
  info.D = {0.02, -0.01, 0.003, -0.001};
  const auto rays = rays_of(info, false, kSize);
  ASSERT_TRUE(rays);
  for (double x = -0.5; x <= 0.5; x += 0.25)
    for (double y = -0.4; y <= 0.4; y += 0.2) {
      const cv::Vec3d point(x, y, 0.8);
      std::vector<cv::Point2d> pixels;
      cv::fisheye::projectPoints(std::vector<cv::Point3d>{cv::Point3d(point)}, pixels, cv::Vec3d(),
                                 cv::Vec3d(), cv::Matx33d(info.K.data()), info.D);
      const cv::Vec3d ray = (*rays)(pixels[0]);
      EXPECT_LT(cv::norm(ray * (0.8 / ray[2]) - point), 1e-6) << x << " " << y;
    }
}

// A camera that sends a part of its sensor, with 2 x 3 pixels binned into one.
TEST(Calibration, RegionAndBinningAreThoseOfTheSensor) {
  auto info = strong_lens();
  info.roi.x_offset = 200;
  info.roi.y_offset = 101;
  info.roi.width = 801;
  info.roi.height = 602;
  info.binning_x = 2;
  info.binning_y = 3;
  const cv::Size size(400, 200);
  EXPECT_EQ(image_size(info), size);
  tf2_ros::Buffer tf;
  const auto raw = calibrate(at_distance(false), &info, header(), size, tf);
  const auto rectified = calibrate(at_distance(true), &info, header(), size, tf);
  ASSERT_TRUE(raw.platform && rectified.platform) << raw.fault << rectified.fault;
  const auto in_image = [](cv::Point2d p) {
    return Pose2D{(p.x - 200 - 0.5) / 2, (p.y - 101 - 1) / 3, 0};
  };
  const cv::Vec3d point(0.12, -0.1, 0.8);
  const auto a = raw.platform->lift(in_image(project(point, info)), {}, 0);
  const auto b = rectified.platform->lift(
      in_image({800 * point[0] / point[2] + 600, 800 * point[1] / point[2] + 500}), {}, 0);
  ASSERT_TRUE(a && b);
  EXPECT_LT(cv::norm(a->position - point), 1e-6);
  EXPECT_LT(cv::norm(b->position - point), 1e-9);
  EXPECT_FALSE(calibrate(at_distance(true), &info, header(), kSize, tf).platform)
      << "not the whole sensor";
}

TEST(Calibration, AnInconsistentRegionHasNoSize) {
  using Spoil = std::function<void(sensor_msgs::CameraInfo&)>;
  for (const Spoil& spoil :
       std::vector<Spoil>{[](auto& i) { i.width = 0; }, [](auto& i) { i.height = 0xffffffffu; },
                          [](auto& i) { i.roi.x_offset = 3; }, [](auto& i) { i.roi.width = 100; },
                          [](auto& i) {
                            i.roi.width = 1280;
                            i.roi.height = 960;
                            i.roi.y_offset = 1;
                          },
                          [](auto& i) { i.binning_x = 1281; }}) {
    auto info = strong_lens();
    spoil(info);
    EXPECT_TRUE(image_size(info).empty());
    EXPECT_FALSE(fault_of_calibration(info, true, {}).empty());
  }
}

TEST(Calibration, TakesThePlatformAtTheImagesStamp) {
  tf2_ros::Buffer tf;
  PlatformConfig config;
  config.platform_frame = "platform";
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "camera";
  transform.child_frame_id = "platform";
  transform.transform.rotation.w = 1;
  for (const double stamp : {9.0, 11.0}) {
    transform.header.stamp = ros::Time(stamp);
    transform.transform.translation.z = stamp / 10;  // the platform sinks
    tf.setTransform(transform, "test");
  }
  const auto info = strong_lens();
  const auto calibration = calibrate(config, &info, header(), kSize, tf);
  ASSERT_TRUE(calibration.platform) << calibration.fault;
  EXPECT_NEAR(calibration.platform->lift({600, 500, 0}, {}, 0)->position[2], 1.0, 1e-9);
  auto later = header();
  later.stamp = ros::Time(12);
  const auto none = calibrate(config, &info, later, kSize, tf);
  EXPECT_FALSE(none.platform) << "tf must not be extrapolated";
  EXPECT_FALSE(none.fault.empty());
}

TEST(Calibration, UnusableCameraInfoIsRefusedWithAReason) {
  using Spoil = std::function<void(sensor_msgs::CameraInfo&)>;
  const std::vector<std::pair<bool, Spoil>> faults{
      {true, [](auto& info) { info.P.fill(0); }},
      {true, [](auto& info) { info.P[0] = kNan; }},
      {true, [](auto& info) { info.P[6] = kNan; }},
      {true, [](auto& info) { info.width = 640; }},
      {false, [](auto& info) { info.K.fill(0); }},
      {false, [](auto& info) { info.K[4] = -900; }},
      {false, [](auto& info) { info.D[1] = kNan; }},
      {false, [](auto& info) { info.height = 0; }},
      {false, [](auto& info) { info.distortion_model = "nonsense"; }}};
  tf2_ros::Buffer tf;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    auto info = strong_lens();
    faults[i].second(info);
    const auto calibration = calibrate(at_distance(faults[i].first), &info, header(), kSize, tf);
    EXPECT_FALSE(calibration.platform) << i;
    EXPECT_FALSE(calibration.fault.empty()) << i;
  }
  EXPECT_FALSE(calibrate(at_distance(true), nullptr, header(), kSize, tf).platform);
  const auto info = strong_lens();
  auto nameless = header();
  nameless.frame_id.clear();
  EXPECT_FALSE(calibrate(at_distance(true), &info, nameless, kSize, tf).platform);
  EXPECT_FALSE(calibrate({}, &info, header(), kSize, tf).platform);
}

/// Expects a message that names the fault.
void expect_fault(bool rectified, const sensor_msgs::CameraInfo& info, const std::string& words) {
  tf2_ros::Buffer tf;
  const auto calibration = calibrate(at_distance(rectified), &info, header(), kSize, tf);
  EXPECT_FALSE(calibration.platform) << words;
  EXPECT_NE(calibration.fault.find(words), std::string::npos)
      << "'" << calibration.fault << "' lacks '" << words << "'";
}

TEST(Calibration, ImplausibleIntrinsicsAreNamed) {
  struct Row {
    bool rectified;
    std::function<void(sensor_msgs::CameraInfo&)> spoil;
    const char* words;
  };
  const std::vector<Row> rows{
      {false, [](auto& i) { i.K[0] = i.K[4] = 1; }, "shorter than a tenth"},
      {true, [](auto& i) { i.P[0] = i.P[5] = 1; }, "shorter than a tenth"},
      {false, [](auto& i) { i.K[0] = 1e-300; }, "shorter than a tenth"},
      {false, [](auto& i) { i.K[4] = 1e308; }, "longer than a hundred"},
      {false, [](auto& i) { i.K[0] *= 3; }, "twice the other"},
      {false, [](auto& i) { i.K[2] = 1e9; }, "principal point"},
      {true, [](auto& i) { i.P[6] = -2000; }, "principal point"},
      {false, [](auto& i) { i.K[1] = 1; }, "skewed"},
      {true, [](auto& i) { i.P[4] = -0.1; }, "skewed"},
      {false, [](auto& i) { i.K[8] = 0; }, "last row"},
      {true, [](auto& i) { i.P[9] = 1; }, "last row"},
      {true, [](auto& i) { i.P[10] = 2; }, "last row"},
      {true, [](auto& i) { i.P[3] = -80; }, "stereo"},
      {true, [](auto& i) { i.P[7] = kNan; }, "stereo"},
      {true, [](auto& i) { i.R = {1, 0, 0, 0, 1, 0, 0, 0, 2}; }, "R is not a rotation"},
      {true, [](auto& i) { i.R[5] = kNan; }, "R is not a rotation"},
      {false, [](auto& i) { i.R = {0, -1, 0, 1, 0, 0, 0, 0, 1}; }, "R rotates"},
      {false, [](auto& i) { i.D.resize(1); }, "D holds 1 numbers, but plumb_bob has 5"},
      {false, [](auto& i) { i.D.resize(3); }, "D holds 3 numbers"},
      {false, [](auto& i) { i.D.resize(6); }, "D holds 6 numbers"},
      {false, [](auto& i) { i.distortion_model = "rational_polynomial"; }, "has 8"},
      {false, [](auto& i) { i.distortion_model = "equidistant"; }, "has 4"},
      {false, [](auto& i) { i.D[4] = kNan; }, "not finite"},
      {false, [](auto& i) { i.distortion_model = "some_lens"; }, "distortion_model"}};
  for (const Row& row : rows) {
    auto info = strong_lens();
    row.spoil(info);
    expect_fault(row.rectified, info, row.words);
  }
}

TEST(Calibration, ALensWithoutCoefficientsIsIdealUnlessAFisheye) {
  auto info = strong_lens();
  tf2_ros::Buffer tf;
  for (const std::size_t count : {0, 3, 5}) {
    info.D.assign(count, 0);
    EXPECT_TRUE(calibrate(at_distance(false), &info, header(), kSize, tf).platform) << count;
  }
  info.distortion_model = "equidistant";
  expect_fault(false, info, "has 4");
}

TEST(Calibration, APlatformNotInFrontOfTheCameraIsRefused) {
  const auto info = strong_lens();
  tf2_ros::Buffer tf;
  PlatformConfig config;
  config.platform_frame = "platform";
  for (const double z : {-0.8, 101.0, 1e6, 1e-4}) {
    tf.setTransform(platform_at(z), "test", true);
    const auto calibration = calibrate(config, &info, header(), kSize, tf);
    EXPECT_FALSE(calibration.platform) << z;
    EXPECT_EQ(calibration.fault.rfind("platform: the ray through the image centre", 0), 0u)
        << calibration.fault;
  }
  tf.setTransform(platform_at(0.8), "test", true);
  EXPECT_TRUE(calibrate(config, &info, header(), kSize, tf).platform);
}

TEST(Calibration, APlatformOfAnotherCameraIsRefused) {
  auto info = strong_lens();
  tf2_ros::Buffer tf;
  PlatformConfig config;
  config.platform_frame = "platform";
  config.platform_intrinsics = "rectified 1280 960 800 800 600 500";
  tf.setTransform(platform_at(0.8), "test", true);
  EXPECT_TRUE(calibrate(config, &info, header(), kSize, tf).platform);
  info.P[0] = info.P[5] = 805;
  const auto none = calibrate(config, &info, header(), kSize, tf);
  EXPECT_FALSE(none.platform);
  EXPECT_NE(none.fault.find("calibrate the platform again"), std::string::npos) << none.fault;
  config.platform_frame.clear();
  config.platform_distance = 0.8;
  EXPECT_TRUE(calibrate(config, &info, header(), kSize, tf).platform) << "of the frame only";
}

}  // namespace
}  // namespace mbncc::nodelets
