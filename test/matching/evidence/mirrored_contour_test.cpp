// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/mirrored_contour.hpp"

#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::evidence {
namespace {

/// An angle with legs of 70 and 52 px, 24 px wide, as in test::angle_map(), and its mirror images.
class MirroredContourTest : public test::MatcherTest {
 protected:
  const Pose2D truth_{170, 120, 0.8};

  static cv::Mat scene_with(const test::LearningImage& source, const Pose2D& pose) {
    cv::Mat scene = test::texture({320, 240}, 77, 5);
    test::place(scene, source, {60, 60}, pose);
    return scene;
  }

  /// A plate without the tip of one of its corners.
  static test::LearningImage cut_plate() {
    cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
    map(cv::Rect(30, 40, 60, 40)) = 255;
    cv::fillPoly(map, std::vector<std::vector<cv::Point>>{{{90, 40}, {86, 40}, {90, 44}}},
                 cv::Scalar(0));
    return test::LearningImage(3, map);
  }

  double better_at(const Pose2D& pose, const test::LearningImage& taught, const cv::Mat& scene,
                   double scale = 1) const {
    const prepared::PreparedObject object(test::object_from(taught, {60, 60, 0}),
                                          prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const cv::Point2d lever = scale * view.reference_in_anchor.position();
    const Pose2D anchor =
        compose(pose, inverse(Pose2D{lever.x, lever.y, view.reference_in_anchor.theta}));
    double largest = -1;
    for (const auto& other : view.mirrored_contour.alternatives(
             view.fine.contour, scene::SceneLevel(scene, 0), anchor, scale))
      largest = std::max(largest, other.advantage);
    return largest;
  }
};

TEST_F(MirroredContourTest, TheObjectFitsBetterThanItsMirrorImage) {
  EXPECT_LT(better_at(truth_, source_, scene_with(source_, truth_)), -0.1);
}

TEST_F(MirroredContourTest, TheMirrorImageFitsATurnedObjectBetter) {
  // The pose at which an angle covers most of its mirror image: rotated by 90 degrees.
  const cv::Mat scene = scene_with(test::mirrored(source_), truth_);
  double most = -1;
  for (int k = 0; k < 36; ++k)
    most = std::max(most, better_at({truth_.x, truth_.y, 2 * kPi * k / 36}, source_, scene));
  EXPECT_GT(most, 0.1);
}

TEST_F(MirroredContourTest, BothContoursAreComparedAtTheirBestPoses) {
  const cv::Mat over = scene_with(test::mirrored(source_), truth_),
                own = scene_with(source_, truth_);
  double best = 0;
  Pose2D at;
  for (int k = 0; k < 72; ++k) {
    const Pose2D pose{truth_.x, truth_.y, 2 * kPi * k / 72};
    const double better = better_at(pose, source_, over);
    if (better > best) at = pose;
    best = std::max(best, better);
  }
  for (int k = 0; k < 8; ++k) {
    const cv::Point2d off = rotate({1, 0}, k * kPi / 4);
    EXPECT_GT(better_at({at.x + 3 * off.x, at.y + 3 * off.y, at.theta}, source_, over), 0.1) << k;
    EXPECT_LT(
        better_at({truth_.x + 2.5 * off.x, truth_.y + 2.5 * off.y, truth_.theta}, source_, own),
        -0.2)
        << k;
  }
}

/// A leg with a flag of this length below its right end.
test::LearningImage flag_of(int length) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(6, 52, 108, 16)) = 255;
  map(cv::Rect(98, 68, 16, length)) = 255;
  return test::LearningImage(3, map);
}

// Where its leg covers that of its mirror image, rotated by 180 degrees, the centres differ.
TEST_F(MirroredContourTest, ATurnedFlagIsDetectedWhereTheLegsCoincide) {
  const Pose2D turned{truth_.x, truth_.y, truth_.theta + kPi};
  for (const int length : {16, 24, 36}) {
    const test::LearningImage flag = flag_of(length);
    const prepared::PreparedObject object(test::object_from(flag, {60, 60, 0}),
                                          prepared::Engine::kFast);
    EXPECT_GT(better_at(turned, flag, scene_with(test::mirrored(flag), truth_)),
              object.views.front().mirrored_contour.limit())
        << length;
    EXPECT_LT(better_at(truth_, flag, scene_with(flag, truth_)), 0);
  }
}

TEST_F(MirroredContourTest, TheDistanceOfTheContoursScalesWithTheSize) {
  const test::LearningImage flag = flag_of(36);
  const cv::Mat scene = scene_with(test::mirrored(flag), truth_);
  for (const double size : {0.92, 1.08}) {
    cv::Mat resized;
    cv::resize(scene, resized, {}, size, size, cv::INTER_LINEAR);
    const Pose2D turned{(truth_.x + 0.5) * size - 0.5, (truth_.y + 0.5) * size - 0.5,
                        truth_.theta + kPi};
    EXPECT_GT(better_at(turned, flag, resized, size), kMirrored) << size;
  }
}

TEST_F(MirroredContourTest, AMirrorSymmetricContourFitsEquallyWell) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(30, 40, 60, 40)) = 255;
  const test::LearningImage plate(3, map);
  EXPECT_NEAR(better_at(truth_, plate, scene_with(plate, truth_)), 0, 0.04);
  const prepared::PreparedObject object(test::object_from(plate, {60, 60, 0}),
                                        prepared::Engine::kFast);
  EXPECT_EQ(object.views.front().mirrored_contour.limit(), kMirrored);
}

TEST_F(MirroredContourTest, ASlightDifferenceIsDetectedWithItsOwnLimit) {
  const test::LearningImage plate = cut_plate();
  const prepared::PreparedObject object(test::object_from(plate, {60, 60, 0}),
                                        prepared::Engine::kFast);
  const double limit = object.views.front().mirrored_contour.limit();
  const double over = better_at(truth_, plate, scene_with(test::mirrored(plate), truth_));
  EXPECT_GT(over, limit);
  EXPECT_LT(limit, kMirrored / 2)
      << "an outline that is its own mirror image may come so near by chance";
  EXPECT_LT(better_at(truth_, plate, scene_with(plate, truth_)), 0);
}

}  // namespace
}  // namespace mbncc::evidence
