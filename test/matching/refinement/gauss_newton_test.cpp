// SPDX-License-Identifier: BSD-3-Clause
// Refinement pulls the pose onto the surface and onto the contour.
#include <gtest/gtest.h>

#include <cmath>

#include "imaging/pyramid.hpp"
#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/refinement/gauss_newton.hpp"

namespace mbncc::refinement {
namespace {

class GaussNewtonTest : public ::testing::Test {
 protected:
  /// An object with texture, or in one colour on a background of another.
  static test::LearningImage lesson(bool textured) {
    test::LearningImage source(41);
    if (textured) return source;
    source.surface.setTo(cv::Scalar(60, 90, 170));
    source.image.setTo(cv::Scalar(150, 150, 150));
    source.surface.copyTo(source.image, source.map);
    return source;
  }

  static cv::Mat scene_with(const test::LearningImage& source, bool textured, const Pose2D& truth) {
    cv::Mat scene = textured ? test::texture({200, 160}, 42, 4)
                             : cv::Mat(160, 200, CV_8UC3, cv::Scalar(140, 140, 140));
    test::place(scene, source, kReference, truth);
    return scene;
  }

  /// The object composited into a scene, with its template's anchor.
  struct Laid {
    Laid(bool textured, const Pose2D& truth)
        : source(lesson(textured)),
          object(test::object_from(source, {kReference.x, kReference.y, 0})),
          view(object->views.front(), prepared::Engine::kFast),
          scene(scene_with(source, textured, truth), 0),
          anchor(compose(truth, inverse(view.reference_in_anchor))) {}

    test::LearningImage source;
    std::shared_ptr<const ObjectModel> object;
    prepared::PreparedView view;
    scene::SceneLevel scene;
    Pose2D anchor;
  };

  /// `pose` displaced by 1.5 px and 2 degrees, in the kth of eight directions.
  static Pose2D beside(const Pose2D& pose, int k) {
    const double direction = k * kPi / 4;
    return {pose.x + 1.5 * std::cos(direction), pose.y + 1.5 * std::sin(direction),
            pose.theta + (k % 2 ? 2 : -2) * kDegree};
  }

  static constexpr double kDegree = kPi / 180;
  static const cv::Point2d kReference;
};

const cv::Point2d GaussNewtonTest::kReference{58, 60};

TEST_F(GaussNewtonTest, ConvergesFromNearbyPoses) {
  for (const bool textured : {true, false}) {
    const Laid laid(textured, {101.4, 77.3, 0.7});
    for (int k = 0; k < 8; ++k) {
      const Pose2D start = beside(laid.anchor, k);
      const AlignedPose aligned = align(laid.view.fine, laid.scene, start, 12);
      EXPECT_LT(cv::norm(aligned.pose.position() - laid.anchor.position()), 0.5)
          << (textured ? "textured" : "plain") << ", direction " << k;
      EXPECT_LT(angle_distance(aligned.pose.theta, laid.anchor.theta), 0.8 * kDegree);
    }
  }
}

TEST_F(GaussNewtonTest, NeverLowersTheValue) {
  const test::LearningImage source = lesson(true);
  const auto object = test::object_from(source, {kReference.x, kReference.y, 0});
  const prepared::PreparedView view(object->views.front(), prepared::Engine::kFast);
  const scene::SceneLevel scene(test::texture({200, 160}, 43), 0);
  for (int k = 0; k < 20; ++k) {
    const Pose2D start{40.0 + 6 * k, 50.0 + 3 * k, 0.3 * k};
    EXPECT_GE(align(view.fine, scene, start, 6).value, align(view.fine, scene, start, 0).value);
  }
}

}  // namespace
}  // namespace mbncc::refinement
