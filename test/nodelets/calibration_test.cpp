// From camera_info and tf to metres: raw and rectified pictures, and calibrations that are none.
#include "nodelets/calibration.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "mbncc/sim/scene.hpp"
#include "nodelets/rays.hpp"
#include "nodelets/rectifier.hpp"
#include "nodelets/simulated_optics.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const cv::Size kSize(1280, 960);

/// A strong barrel, the principal point far from the middle.
sensor_msgs::CameraInfo strong_lens() {
  sensor_msgs::CameraInfo info;
  info.width = 1280;
  info.height = 960;
  info.distortion_model = "plumb_bob";
  info.D = {-0.3, 0.1, 0.001, -0.002, 0};
  info.K = {900, 0, 580, 0, 910, 530, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {800, 0, 600, 0, 0, 800, 500, 0, 0, 0, 1, 0};
  return info;
}

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(10);
  return header;
}

PlatformConfig at_distance(bool rectified) {
  PlatformConfig config;
  config.platform_distance = 0.8;
  config.rectified = rectified;
  return config;
}

/// The pixel of a point [m] in the raw picture.
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

TEST(Rays, AreNotFiniteWhereTheLensFoldsOver) {
  auto info = strong_lens();
  info.D = {-0.9, 0, 0, 0, 0};
  const auto rays = rays_of(info, false, kSize);
  ASSERT_TRUE(rays);
  EXPECT_TRUE(std::isnan((*rays)({1279, 0})[0]));
  EXPECT_FALSE(std::isnan((*rays)({580, 530})[0]));
}

TEST(Calibration, RawAndRectifiedPicturesGiveTheSameMetres) {
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

TEST(Calibration, TakesThePlatformAtThePicturesStamp) {
  tf2_ros::Buffer tf;
  PlatformConfig config;
  config.platform_frame = "platform";
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "camera";
  transform.child_frame_id = "platform";
  transform.transform.rotation.w = 1;
  for (const double stamp : {9.0, 11.0}) {
    transform.header.stamp = ros::Time(stamp);
    transform.transform.translation.z = stamp / 10;  // it sinks
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

TEST(Calibration, UnusableCameraInfoIsRefusedWithASentence) {
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

SimulatedCameraConfig distorted_cell() {
  SimulatedCameraConfig config;
  config.width = 320;
  config.height = 240;
  config.focal_length = 225;
  config.distortion = -0.3;
  config.principal_x = 20;
  config.principal_y = -15;
  return config;
}

TEST(Rectifier, GivesTheUndistortedPictureBack) {
  const SimulatedOptics optics(distorted_cell());
  sim::SceneConfig scene_config;
  scene_config.size = {320, 240};
  const cv::Mat straight = sim::Scene(scene_config).render({{{3, 80, 1.6}, {180, 130, 0.4}}});
  const cv::Mat raw = optics.distort(straight);
  Rectifier rectifier;
  const Rectified rectified = rectifier.rectify(raw, optics.camera_info());
  ASSERT_TRUE(rectified) << rectified.fault;
  const cv::Rect inner(60, 40, 200, 160);
  cv::Mat difference;
  cv::absdiff(rectified.picture(inner), straight(inner), difference);
  EXPECT_LT(cv::mean(difference)[1], 3);
  cv::absdiff(raw(inner), straight(inner), difference);
  EXPECT_GT(cv::mean(difference)[1], 5) << "the lens shows";
}

TEST(Rectifier, RefusesACalibrationOfAnotherSizeOrNone) {
  Rectifier rectifier;
  const cv::Mat picture(240, 320, CV_8UC3, cv::Scalar::all(7));
  EXPECT_FALSE(rectifier.rectify(picture, strong_lens()));
  EXPECT_FALSE(rectifier.rectify(picture, {}));
}

}  // namespace
}  // namespace mbncc::nodelets
