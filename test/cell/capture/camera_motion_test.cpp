// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/camera_motion.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(640, 480);
constexpr int kBeyond = 100;  // [px] of the cell on every side of the image

/// The part of a larger cell that a camera sees.
class CameraMotion : public testing::Test {
 protected:
  static sim::SceneConfig scene_config() {
    sim::SceneConfig config;
    config.size = kSize + cv::Size(2 * kBeyond, 2 * kBeyond);
    config.light_gradient = 0;
    return config;
  }

  cv::Mat seen(const cv::Mat& cell, cv::Point2d shift = {}, double degrees = 0, double zoom = 1) {
    cv::Mat motion = cv::getRotationMatrix2D({cell.cols / 2.f, cell.rows / 2.f}, degrees, zoom),
            image;
    motion.at<double>(0, 2) += shift.x - kBeyond;
    motion.at<double>(1, 2) += shift.y - kBeyond;
    cv::warpAffine(cell, image, motion, kSize, cv::INTER_CUBIC);
    return image;
  }

  const sim::Scene scene_{scene_config()};
  const sim::Placed part_{{11, 120, 1.6}, {400, 340, 0.3}};
  const cv::Mat cell_ = scene_.render({part_}, 1), again_ = scene_.render({part_}, 2);
};

TEST_F(CameraMotion, IsDetectedForShiftRotationAndZoom) {
  const cv::Mat before = seen(cell_);
  for (const cv::Point2d shift : {cv::Point2d(4, 2), {-15, 5}, {30, -10}, {90, 40}})
    EXPECT_TRUE(camera_moved(before, seen(again_, shift))) << shift;
  for (const double degrees : {1., -3., 10.})
    EXPECT_TRUE(camera_moved(before, seen(again_, {}, degrees))) << degrees;
  for (const double zoom : {1.02, 1.1})
    EXPECT_TRUE(camera_moved(before, seen(again_, {}, 0, zoom))) << zoom;
}

TEST_F(CameraMotion, IsDetectedWhenTheObjectLeavesAtTheSameTime) {
  EXPECT_TRUE(camera_moved(seen(cell_), seen(scene_.render({}, 2), {20, 8})));
}

TEST_F(CameraMotion, ThingsInFrontOfAStillCameraAreNoCameraMotion) {
  const cv::Mat before = seen(cell_);
  sim::Placed elsewhere = part_;
  elsewhere.pose = {250, 250, 1.3};
  EXPECT_FALSE(camera_moved(before, seen(again_)));
  EXPECT_FALSE(camera_moved(before, seen(scene_.render({}, 2))));
  EXPECT_FALSE(camera_moved(before, seen(scene_.render({elsewhere}, 2))));
  EXPECT_FALSE(
      camera_moved(before, seen(scene_.render({part_}, 2, sim::Arm{{400, 340, -1.57}, 60}))));
  EXPECT_FALSE(camera_moved(before, cv::Mat(0.5 * seen(again_))));
}

TEST_F(CameraMotion, ANudgedLargeObjectIsNoCameraMotion) {
  const auto nudged = [this](double by) {
    return seen(scene_.render({{{11, 330, 1.2}, {400 + by, 340, 0.3}}}, by == 0 ? 1 : 2));
  };
  for (const double by : {4., 10.}) EXPECT_FALSE(camera_moved(nudged(0), nudged(by))) << by;
}

TEST_F(CameraMotion, IsNotDetectedWithoutTexture) {
  cv::Mat grey(kSize, CV_8UC3, cv::Scalar::all(120)), noisy(kSize, CV_8UC3);
  EXPECT_FALSE(camera_moved(grey, grey));
  cv::RNG random(1);
  random.fill(noisy, cv::RNG::NORMAL, cv::Scalar::all(120), cv::Scalar::all(3));
  EXPECT_FALSE(camera_moved(grey, noisy));
}

}  // namespace
}  // namespace mbncc
