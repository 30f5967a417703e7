// SPDX-License-Identifier: BSD-3-Clause
// From images to metres with the claimed covariance, in a simulated cell whose truth is known.
#include <gtest/gtest.h>

#include <random>

#include "mbncc/cell/platform.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

constexpr PinholeCamera kCamera{900, 900, 215.3, 172.8};
constexpr double kDistance = 0.8, kHeight = 0.03;  // [m]
constexpr int kObjects = 16, kPoses = 4;

sim::Scene scene_of(int object, double noise) {
  sim::SceneConfig config;
  config.size = {440, 340};
  config.seed = static_cast<std::uint64_t>(object + 1);
  config.noise_sigma = noise;
  return sim::Scene(config);
}

Matcher matcher_taught(const sim::Scene& scene, const sim::Placed& placed) {
  auto object = std::make_shared<ObjectModel>();
  object->name = "part";
  object->views.push_back(
      crop_view(scene.render({placed}, 1), scene.true_map(placed), placed.pose));
  Matcher matcher;
  matcher.set_objects({std::move(object)});
  return matcher;
}

/// Squared error of position on the platform and yaw, weighted by the claimed covariance: 3 is
/// honest.
double squared_error(const PlatformPose& found, const PlatformPose& truth) {
  const cv::Matx33d turn = found.rotation * truth.rotation.t();
  const cv::Vec3d error(found.position[0] - truth.position[0],
                        found.position[1] - truth.position[1], std::atan2(turn(1, 0), turn(0, 0)));
  constexpr int kRows[] = {0, 1, 5};
  cv::Matx33d covariance;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) covariance(i, j) = found.covariance(kRows[i], kRows[j]);
  return error.dot(covariance.inv() * error);
}

/// Error by claimed deviation over poses of several objects, each a root mean square.
double normalised_error(double noise) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(90, 350), y(90, 250), theta(-kPi, kPi), size(50, 110);
  const Platform platform(rays_of(kCamera), plane_at(kDistance));
  double total = 0;
  int count = 0;
  for (int object = 0; object < kObjects; ++object) {
    const sim::Scene scene = scene_of(object, noise);
    sim::Placed placed{{static_cast<std::uint64_t>(object + 40), size(random), 1.6},
                       {220.3, 170.6, 0.4}};
    const Matcher matcher = matcher_taught(scene, placed);
    for (int i = 0; i < kPoses; ++i, ++count) {
      placed.pose = {x(random), y(random), theta(random)};
      const auto found = matcher.find(scene.render({placed}, 10 + i)).matches;
      if (found.empty() || !found[0].graspable) {
        ADD_FAILURE() << "object " << object << " is not found at pose " << i;
        continue;
      }
      total += squared_error(*platform.lift(found[0].pose, found[0].covariance, kHeight),
                             *platform.lift(placed.pose, cv::Matx33d::zeros(), kHeight));
    }
  }
  return std::sqrt(total / (3 * count));
}

TEST(MetricAccuracy, ErrorsAreAsLargeAsClaimed) {
  for (const double noise : {1., 2., 4.}) {
    const double error = normalised_error(noise);
    EXPECT_GT(error, 0.7) << "noise " << noise;
    EXPECT_LT(error, 1.3) << "noise " << noise;
  }
}

}  // namespace
}  // namespace mbncc
