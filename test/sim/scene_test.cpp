// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/sim/scene.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "sim/drawing.hpp"

namespace mbncc::sim {
namespace {

SceneConfig quiet() {
  SceneConfig config;
  config.size = {240, 200};
  config.noise_sigma = 0;
  config.light_gradient = 0;
  return config;
}

SceneObject object_of(std::uint64_t seed) {
  SceneObject object;
  object.seed = seed;
  return object;
}

bool identical(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

TEST(Scene, SameSeedSameImage) {
  SceneConfig config;
  config.size = {160, 120};
  const Placed placed{object_of(3), {80.2, 60.7, 0.4}};
  EXPECT_TRUE(identical(Scene(config).render({placed}, 5), Scene(config).render({placed}, 5)));
  EXPECT_FALSE(identical(Scene(config).render({placed}, 5), Scene(config).render({placed}, 6)));
  SceneConfig other = config;
  other.seed = 2;
  EXPECT_FALSE(identical(Scene(config).render({placed}, 5), Scene(other).render({placed}, 5)));
}

/// Centroid of the area that an object actually covers.
cv::Point2d covered_centroid(const Placed& placed, cv::Size image) {
  cv::Rect where;
  const cv::Mat cover = coverage(draw_object(placed.object), placed.pose, image, where);
  const cv::Moments moments = cv::moments(cover);
  return {where.x + moments.m10 / moments.m00, where.y + moments.m01 / moments.m00};
}

TEST(Scene, PoseIsTheCentroidOfTheCoveredArea) {
  cv::RNG random(1);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Placed placed{
        object_of(seed),
        {random.uniform(90.0, 150.0), random.uniform(80.0, 120.0), random.uniform(-kPi, kPi)}};
    const cv::Point2d error = covered_centroid(placed, quiet().size) - placed.pose.position();
    EXPECT_LT(cv::norm(error), 0.02) << seed;
  }
}

TEST(Scene, TrueMapLiesAtThePose) {
  const Scene scene(quiet());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Placed placed{object_of(seed), {120.4, 99.7, 0.3 * seed}};
    EXPECT_LT(cv::norm(centroid(scene.true_map(placed)) - placed.pose.position()), 0.25) << seed;
  }
}

/// Shift of `b` relative to `a`, by least squares on the gradient inside `map`.
cv::Point2d shift_between(const cv::Mat& a, const cv::Mat& b, const cv::Mat& map) {
  cv::Mat first, second, gx, gy, inner;
  cv::cvtColor(a, first, cv::COLOR_BGR2GRAY);
  cv::cvtColor(b, second, cv::COLOR_BGR2GRAY);
  cv::Mat both;
  cv::addWeighted(first, 0.5, second, 0.5, 0, both, CV_32F);
  cv::Sobel(both, gx, CV_32F, 1, 0, 3, 1.0 / 8);
  cv::Sobel(both, gy, CV_32F, 0, 1, 3, 1.0 / 8);
  cv::erode(map, inner, cv::Mat(), {-1, -1}, 3);
  cv::Matx22d normal = cv::Matx22d::zeros();
  cv::Vec2d right;
  for (int y = 1; y < inner.rows - 1; ++y) {
    for (int x = 1; x < inner.cols - 1; ++x) {
      if (inner.at<uchar>(y, x) == 0) continue;
      const cv::Vec2d g(gx.at<float>(y, x), gy.at<float>(y, x));
      normal += g * g.t();
      right += g * (first.at<uchar>(y, x) - double(second.at<uchar>(y, x)));
    }
  }
  const cv::Vec2d shift = normal.inv() * right;
  return {shift[0], shift[1]};
}

TEST(Scene, ShiftByAWholePixelShiftsTheMap) {
  const Scene scene(quiet());
  const cv::Mat map = scene.true_map({object_of(4), {120.3, 100, 0.3}});
  const cv::Mat shifted = scene.true_map({object_of(4), {121.3, 100, 0.3}});
  EXPECT_TRUE(identical(map.colRange(0, 239), shifted.colRange(1, 240)));
}

TEST(Scene, SurfaceFollowsSubPixelShifts) {
  SceneConfig config = quiet();
  config.blur_sigma = 2.5;  // the grey levels are linear over the shift
  const Scene scene(config);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Placed at{object_of(seed), {120, 100, 0.3}}, moved{object_of(seed), {120.25, 99.9, 0.3}};
    const cv::Point2d shift =
        shift_between(scene.render({at}), scene.render({moved}), scene.true_map(at));
    EXPECT_NEAR(shift.x, 0.25, 0.02) << seed;
    EXPECT_NEAR(shift.y, -0.1, 0.02) << seed;
  }
}

TEST(Scene, TurningTheObjectTurnsItsImage) {
  const Scene scene(quiet());
  const Placed placed{object_of(7), {120, 100, 0}}, turned{object_of(7), {120, 100, kPi / 2}};
  const cv::Mat a = scene.render({placed}), b = scene.render({turned});
  const cv::Mat map = scene.true_map(placed);
  double sum = 0;
  int count = 0;
  for (int y = 40; y < 160; ++y) {
    for (int x = 60; x < 180; ++x) {
      if (map.at<uchar>(y, x) == 0) continue;
      const cv::Point2d to = transform(turned.pose, cv::Point2d(x - 120, y - 100));
      const cv::Vec3b from = a.at<cv::Vec3b>(y, x), there = b.at<cv::Vec3b>(cv::Point(to));
      sum += cv::norm(cv::Vec3d(from) - cv::Vec3d(there));
      ++count;
    }
  }
  EXPECT_GT(count, 1000);
  EXPECT_LT(sum / count, 2.0);
}

TEST(Scene, ObjectsOfDifferentSeedsDiffer) {
  const Scene scene(quiet());
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    const cv::Mat a = scene.render({{object_of(seed), {120, 100, 0}}});
    const cv::Mat b = scene.render({{object_of(seed + 1), {120, 100, 0}}});
    EXPECT_GT(cv::norm(a, b, cv::NORM_L1) / (3 * a.total()), 2.0) << seed;
  }
}

TEST(Scene, ObjectHasTheDiameterAskedFor) {
  const Scene scene(quiet());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const cv::Mat map = scene.true_map({object_of(seed), {120, 100, 0.5}});
    EXPECT_NEAR(2 * excircle(map).radius, 90, 2) << seed;
  }
}

TEST(Scene, NoiseAndGainAreAsConfigured) {
  SceneConfig config = quiet();
  config.noise_sigma = 3;
  const Scene scene(config);
  cv::Mat difference;
  cv::subtract(scene.render({}, 1), scene.render({}, 2), difference, cv::noArray(), CV_32F);
  cv::Scalar mean, deviation;
  cv::meanStdDev(difference, mean, deviation);
  EXPECT_NEAR(deviation[0] / std::sqrt(2.0), 3, 0.5);

  SceneConfig bright = quiet();
  bright.gain = 1.2;
  const double ratio = cv::sum(Scene(bright).render({}))[0] / cv::sum(Scene(quiet()).render({}))[0];
  EXPECT_NEAR(ratio, 1.2, 0.02);
}

TEST(Scene, ArmCoversWhatItReachesOver) {
  const Scene scene(quiet());
  const Arm arm{{120, 100, kPi}};
  const cv::Mat without = scene.render({}), with = scene.render({}, 0, arm);
  cv::Mat difference;
  cv::absdiff(without, with, difference);
  // The arm extends to the left, so it enters from the right.
  EXPECT_GT(cv::mean(difference(cv::Rect(215, 80, 20, 40)))[1], 10);
  EXPECT_EQ(cv::mean(difference(cv::Rect(0, 0, 40, 200)))[1], 0);
}

TEST(Scene, ThingsOutsideTheImageAreLeftOut) {
  const Scene scene(quiet());
  const Placed outside{object_of(1), {-500, 100, 0}};
  EXPECT_TRUE(identical(scene.render({outside}), scene.render({})));
  EXPECT_EQ(cv::countNonZero(scene.true_map(outside)), 0);
}

TEST(Scene, RefusesATinyImage) {
  SceneConfig config;
  config.size = {8, 8};
  EXPECT_THROW(Scene{config}, std::invalid_argument);
}

}  // namespace
}  // namespace mbncc::sim
