// SPDX-License-Identifier: BSD-3-Clause
// Poses in metres and their stated covariance, tested in a simulated cell with known truth.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

#include "mbncc/cell/image_distortion.hpp"
#include "mbncc/cell/platform.hpp"
#include "mbncc/cell/top_view.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

constexpr PinholeCamera kCamera{900, 900, 215.3, 172.8};
constexpr double kDistance = 0.8, kHeight = 0.03;  // [m]
const cv::Size kImage(440, 340);
constexpr int kObjects = 16, kPoses = 4;

/// A camera at the position of kCamera, from which the scene is drawn, and the platform below it.
struct Viewer {
  cv::Matx33d rotation = cv::Matx33d::eye();  // from the drawing's frame
  PinholeCamera camera = kCamera;

  Plane plane() const {
    return {rotation * cv::Vec3d(0, 0, kDistance), rotation * cv::Vec3d(0, 0, -1)};
  }
};

cv::Matx33d matrix_of(const PinholeCamera& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

/// The image of `of` as the viewer `by` would see it.
cv::Mat seen(const cv::Mat& image, const Viewer& by, const Viewer& of, int interpolation) {
  if (cv::norm(by.rotation - of.rotation) == 0) return image;
  cv::Mat result;
  cv::warpPerspective(
      image, result,
      matrix_of(by.camera) * by.rotation * of.rotation.t() * matrix_of(of.camera).inv(),
      image.size(), interpolation, cv::BORDER_REFLECT_101);
  return result;
}

Viewer tilted(double degrees) {
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  Viewer viewer{{1, 0, 0, 0, c, -s, 0, s, c}, {}};
  // The principal point is moved so that the drawing stays in view.
  viewer.camera = {kCamera.fx, kCamera.fy, kCamera.cx, kCamera.cy + kCamera.fy * s / c};
  return viewer;
}

sim::Scene scene_of(int object, double noise) {
  sim::SceneConfig config;
  config.size = kImage;
  config.seed = static_cast<std::uint64_t>(object + 1);
  config.noise_sigma = noise;
  return sim::Scene(config);
}

/// A pose of the drawing as a viewer sees it.
Pose2D pose_in(const Viewer& viewer, const Pose2D& pose) {
  const auto seen_at = [&](cv::Point2d pixel) {
    const cv::Vec3d ray = viewer.rotation * rays_of(kCamera)(pixel);
    return cv::Point2d(viewer.camera.fx * ray[0] / ray[2] + viewer.camera.cx,
                       viewer.camera.fy * ray[1] / ray[2] + viewer.camera.cy);
  };
  const cv::Point2d place = seen_at(pose.position());
  const cv::Point2d ahead = seen_at(pose.position() + rotate({0.01, 0}, pose.theta)) - place;
  return {place.x, place.y, std::atan2(ahead.y, ahead.x)};
}

/// The images that are learned and searched: those of `camera`, resampled to the viewer `shown` at
/// the same position.
struct Views {
  Viewer camera, shown;
  ImageDistortion stated;

  /// Sharp for the camera, interpolated like a rectified image for the other viewer.
  cv::Mat of_drawing(const cv::Mat& drawing) const {
    return seen(seen(drawing, camera, {}, cv::INTER_LANCZOS4), shown, camera, cv::INTER_LINEAR);
  }

  cv::Mat image_of(const sim::Scene& scene, const sim::Placed& placed, int time) const {
    return of_drawing(scene.render({placed}, static_cast<std::uint64_t>(time)));
  }

  Matcher taught(const sim::Scene& scene, const sim::Placed& placed) const {
    auto object = std::make_shared<ObjectModel>();
    object->name = "part";
    object->views.push_back(crop_view(image_of(scene, placed, 1),
                                      cv::Mat(of_drawing(scene.true_map(placed)) >= 128),
                                      pose_in(shown, placed.pose)));
    Matcher matcher;
    matcher.set_objects({std::move(object)});
    return matcher;
  }
};

/// Squared error of position and yaw on the platform, weighted by the stated covariance; the
/// expected value is 3.
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

/// Root mean square of the error divided by the stated deviation, over poses of several objects.
double normalised_error(double noise, const Views& views = {}) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(90, 350), y(90, 250), theta(-kPi, kPi), size(50, 110);
  const Viewer& viewer = views.shown;
  const Platform platform(rays_of(viewer.camera), viewer.plane());
  double total = 0;
  int count = 0;
  for (int object = 0; object < kObjects; ++object) {
    const sim::Scene scene = scene_of(object, noise);
    sim::Placed placed{{static_cast<std::uint64_t>(object + 40), size(random), 1.6},
                       {220.3, 170.6, 0.4}};
    const Matcher matcher = views.taught(scene, placed);
    for (int i = 0; i < kPoses; ++i, ++count) {
      placed.pose = {x(random), y(random), theta(random)};
      const auto found = matcher.find(views.image_of(scene, placed, 10 + i)).matches;
      if (found.empty() || !found[0].graspable) {
        ADD_FAILURE() << "object " << object << " is not found at pose " << i;
        continue;
      }
      const cv::Matx33d covariance =
          with_distortion(found[0].covariance, views.stated, found[0].outline);
      total += squared_error(*platform.lift(found[0].pose, covariance, kHeight),
                             *platform.lift(pose_in(viewer, placed.pose), {}, kHeight));
    }
  }
  return std::sqrt(total / (3 * count));
}

TEST(MetricAccuracy, ErrorsMatchTheStatedCovariance) {
  for (const double noise : {1., 2., 4.}) {
    const double error = normalised_error(noise);
    EXPECT_GT(error, 0.7) << "noise " << noise;
    EXPECT_LT(error, 1.3) << "noise " << noise;
  }
}

TEST(MetricAccuracy, ATiltedCamerasErrorsAreStated) {
  const Viewer camera = tilted(8);
  const ImageDistortion stated = distortion_of({rays_of(camera.camera), camera.plane()}, kImage);
  EXPECT_GT(normalised_error(2, {camera, camera, {}}), 3) << "not those of an upright one";
  EXPECT_LT(normalised_error(2, {camera, camera, stated}), 1.3);
}

TEST(MetricAccuracy, ATopViewHasTheErrorsOfAnUprightCamera) {
  const Viewer camera = tilted(8);
  const TurnedCamera view = top_view(camera.camera, camera.plane(), kImage);
  const double error =
      normalised_error(2, {camera, {view.rotation * camera.rotation, view.camera}, {}});
  EXPECT_GT(error, 0.7);
  EXPECT_LT(error, 1.3);
}

}  // namespace
}  // namespace mbncc
