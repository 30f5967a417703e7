// SPDX-License-Identifier: BSD-3-Clause
// Tests of alternatives to a pose.
#include <cmath>
#include <memory>

#include "matching/evidence/contour_alternative.hpp"
#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/refinement/refinement.hpp"
#include "matching/search/verification.hpp"

namespace mbncc {
namespace {

class VerificationTest : public test::MatcherTest {
 protected:
  const prepared::PreparedObject object_{test::object_from(source_, reference_),
                                         prepared::Engine::kFast};
  const prepared::PreparedView& view_ = object_.views.front();
  const Pose2D truth_{170, 120, 0.8};

  static cv::Mat scene_with(const test::LearningImage& source, const Pose2D& pose) {
    cv::Mat scene = test::texture({320, 240}, 77, 5);
    test::place(scene, source, {58, 60}, pose);
    return scene;
  }

  Pose2D anchor_at(const Pose2D& reference, double size = 1) const {
    const cv::Point2d lever = size * view_.reference_in_anchor.position();
    return compose(reference, inverse(Pose2D{lever.x, lever.y, view_.reference_in_anchor.theta}));
  }

  static cv::Mat resized(const cv::Mat& image, double size) {
    cv::Mat resized;
    cv::resize(image, resized, {}, size, size, size < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    return resized;
  }

  scene::SceneImage resized_scene(double size) const {
    return {resized(scene_with(source_, truth_), size), object_.top_level()};
  }

  Pose2D truth_in(double size) const {
    return {(truth_.x + 0.5) * size - 0.5, (truth_.y + 0.5) * size - 0.5, truth_.theta};
  }

  /// The best detection for a pose hypothesis of the anchor.
  decision::Detection judged(const scene::SceneImage& scene, const Pose2D& anchor,
                             double odds) const {
    search::PoseHypothesis hypothesis = search::score_as_is(view_, scene, anchor);
    hypothesis.odds = odds;
    return search::verify(object_, view_, scene, {hypothesis}).at(0);
  }

  /// The best detection of a likely `object` whose reference point is at `truth`.
  static decision::Detection judged_of(const prepared::PreparedObject& object,
                                       const scene::SceneImage& scene, const Pose2D& truth) {
    const prepared::PreparedView& view = object.views.front();
    search::PoseHypothesis found =
        search::score_as_is(view, scene, compose(truth, inverse(view.reference_in_anchor)));
    found.odds = 12;
    return search::verify(object, view, scene, {found}).at(0);
  }
};

TEST_F(VerificationTest, TheTrueObjectHasNoDoubts) {
  const scene::SceneImage scene(scene_with(source_, truth_), object_.top_level());
  const decision::Detection found = judged(scene, anchor_at(truth_), 30);
  EXPECT_LT(found.colour_difference, 0.1);
  EXPECT_LT(found.print_difference, 0.1);
  EXPECT_LT(found.continued, 0.1);
  EXPECT_FALSE(found.size_alternative);
  EXPECT_FALSE(found.mirror_alternative);
  EXPECT_DOUBLE_EQ(found.log_odds(), 30);
  EXPECT_DOUBLE_EQ(found.visible, 1);
  EXPECT_LT(found.contour_alternative, -0.1);
  EXPECT_DOUBLE_EQ(
      found.contour_alternative,
      evidence::advantage_elsewhere(view_.fine.contour, scene.levels[0], found.pose, found.scale));
  const refinement::Refined refined =
      refinement::refine(view_.dense, scene.levels[0], anchor_at(truth_), 4);
  EXPECT_EQ(found.covariance, refined.covariance);
  EXPECT_EQ(found.pose.position(), refined.pose.position());
}

TEST_F(VerificationTest, TheTrueObjectHasTheLearnedSize) {
  const scene::SceneImage scene(scene_with(source_, truth_), object_.top_level());
  search::PoseHypothesis hypothesis = search::score_as_is(view_, scene, anchor_at(truth_));
  const decision::Detection found = search::verify(object_, view_, scene, {hypothesis}).at(0);
  EXPECT_FALSE(found.size_alternative);
  EXPECT_EQ(found.scale, 1);
  EXPECT_EQ(found.odds.resized, 0);
}

TEST_F(VerificationTest, UnlikelyHypothesesAreNotExamined) {
  const scene::SceneImage scene(scene_with(source_, truth_), object_.top_level());
  const decision::Detection found = judged(scene, anchor_at(truth_), -3);
  EXPECT_GE(found.covariance(0, 0), 1e4);
  EXPECT_GE(found.covariance(1, 1), 1e4);
  EXPECT_GT(found.covariance(2, 2), 4 * kPi);
  EXPECT_DOUBLE_EQ(found.contour_alternative, decision::kNotExamined);
}

// At the learned size, its edges are 4 px away.
TEST_F(VerificationTest, ALargeObjectIsFoundAtASlightlyDifferentSize) {
  cv::Mat map = cv::Mat::zeros(240, 240, CV_8UC1);
  map(cv::Rect(40, 70, 160, 100)) = 255;
  test::LearningImage plate(3, map);
  // If there is little texture, the edges determine the size.
  plate.surface.convertTo(plate.surface, -1, 0.1, 120);
  plate.surface.copyTo(plate.image, map);
  const prepared::PreparedObject object(test::object_from(plate, {120, 120, 0}),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  cv::Mat image = test::texture({400, 400}, 77, 5);
  test::place(image, plate, {120, 120}, {200, 200, 0.8});
  for (const double size : {0.95, 1.05}) {
    const scene::SceneImage scene(resized(image, size), object.top_level());
    const cv::Point2d lever = size * view.reference_in_anchor.position();
    const Pose2D there = compose({200.5 * size - 0.5, 200.5 * size - 0.5, 0.8},
                                 inverse(Pose2D{lever.x, lever.y, 0}));
    // One side of the object has been aligned at the learned size.
    search::PoseHypothesis hypothesis =
        search::score_as_is(view, scene, {there.x + 2, there.y - 2, there.theta});
    hypothesis.odds = 8;
    const decision::Detection found = search::verify(object, view, scene, {hypothesis}).at(0);
    EXPECT_FALSE(found.size_alternative) << size;
    EXPECT_NEAR(found.scale, size, 0.005);
    EXPECT_LT(cv::norm(found.pose.position() - there.position()), 0.5);
    EXPECT_GT(found.log_odds(), 10) << "what is judged is judged at that size";
    EXPECT_DOUBLE_EQ(found.odds.resized, found.odds.evidence - hypothesis.odds);
  }
}

TEST_F(VerificationTest, AnotherSizeIsDetected) {
  for (const double size : {0.85, 0.9, 0.92, 1.08, 1.1, 1.15})
    EXPECT_TRUE(judged(resized_scene(size), anchor_at(truth_in(size), size), 1).size_alternative)
        << size;
}

TEST_F(VerificationTest, AnotherSizeIsNotExcludedForUnlikelyHypotheses) {
  const scene::SceneImage scene(scene_with(source_, truth_), object_.top_level());
  EXPECT_TRUE(judged(scene, anchor_at(truth_), -1).size_alternative);
}

TEST_F(VerificationTest, TheMirrorImageIsDetectedAndLowersTheOdds) {
  const scene::SceneImage scene(scene_with(test::mirrored(source_), truth_), object_.top_level());
  const decision::Detection found = judged(scene, {truth_.x, truth_.y, 0}, 10);
  EXPECT_TRUE(found.mirror_alternative);
  EXPECT_LT(found.colour_difference, 0.15) << "no colour differs";
  EXPECT_LT(found.log_odds(), 8);
}

TEST_F(VerificationTest, ARoundObjectHasNoMirrorImage) {
  auto model = std::make_shared<ObjectModel>(*test::object_from(source_, reference_));
  model->symmetry = 0;
  const prepared::PreparedObject object(model, prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const scene::SceneImage scene(scene_with(test::mirrored(source_), truth_), object.top_level());
  search::PoseHypothesis hypothesis = search::score_as_is(view, scene, {truth_.x, truth_.y, 0});
  hypothesis.odds = 10;
  const decision::Detection found = search::verify(object, view, scene, {hypothesis}).at(0);
  EXPECT_FALSE(found.mirror_alternative);
  EXPECT_DOUBLE_EQ(found.odds.mirror, 0);
}

/// A plate that differs from its mirror image only by the missing tip [px] of one corner.
test::LearningImage plate_without_tip(int tip) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(10, 25, 100, 70)) = 255;
  cv::fillPoly(map,
               std::vector<std::vector<cv::Point>>{{{110, 25}, {110 - tip, 25}, {110, 25 + tip}}},
               cv::Scalar(0));
  return test::LearningImage(3, map);
}

TEST_F(VerificationTest, ASlightlyDifferentMirrorImageIsDetected) {
  const test::LearningImage plate = plate_without_tip(5);
  const test::LearningImage mirrored = test::mirrored(plate);
  const prepared::PreparedObject object(test::object_from(plate, {60, 60, 0}),
                                        prepared::Engine::kFast);
  for (const bool over : {false, true}) {
    const scene::SceneImage scene(scene_with(over ? mirrored : plate, truth_), object.top_level());
    EXPECT_EQ(judged_of(object, scene, truth_).mirror_alternative, over);
  }
}

// The plate shows its own print within the mirrored outline.
TEST_F(VerificationTest, ASurfaceThatContradictsTheMirrorImageDecides) {
  const test::LearningImage plate = plate_without_tip(24);
  test::LearningImage seen = plate;
  seen.map = test::mirrored(plate).map;
  const prepared::PreparedObject object(test::object_from(plate, reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const scene::SceneImage scene(scene_with(seen, truth_), object.top_level());
  const decision::Detection judged = judged_of(object, scene, truth_);
  EXPECT_FALSE(judged.mirror_alternative);
  double largest = -1;
  for (const auto& other : view.mirrored_contour.alternatives(view.fine.contour, scene.levels[0],
                                                              judged.pose, judged.scale))
    largest = std::max(largest, other.advantage);
  EXPECT_GT(largest, view.mirrored_contour.limit());
}

/// An object of 120 px whose surface is its own mirror image.
test::LearningImage with_mirrored_surface(test::LearningImage object) {
  cv::Mat right_half;
  cv::flip(object.surface.colRange(0, 60), right_half, 1);
  right_half.copyTo(object.surface.colRange(60, 120));
  object.surface.copyTo(object.image, object.map);
  return object;
}

TEST_F(VerificationTest, AnOutlineThatIsItsOwnMirrorImageMayFitALittleBetterMirrored) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(10, 25, 100, 70)) = 255;
  const test::LearningImage plate = with_mirrored_surface(test::LearningImage(3, map));
  const prepared::PreparedObject object(test::object_from(plate, reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  int better = 0;
  for (int k = 0; k < 8; ++k) {
    const Pose2D truth{160 + 0.3 * k, 120 - 0.2 * k, 0.7 * k};
    const scene::SceneImage scene(scene_with(plate, truth), object.top_level());
    const decision::Detection judged = judged_of(object, scene, truth);
    EXPECT_FALSE(judged.mirror_alternative) << k;
    for (const auto& other : view.mirrored_contour.alternatives(view.fine.contour, scene.levels[0],
                                                                judged.pose, judged.scale))
      if (other.advantage > 0) ++better;
  }
  EXPECT_GT(better, 0) << "nothing was tested";
}

// The mirrored outline fits at two rotations, better at the one that the surface contradicts.
TEST_F(VerificationTest, EachMirroredOutlineIsComparedWithTheSurface) {
  const auto plate_without_tips = [](int right, int left) {
    cv::Mat map = plate_without_tip(right).map;
    const std::vector<cv::Point> corner{{10, 94}, {10 + left, 94}, {10, 94 - left}};
    cv::fillPoly(map, std::vector<std::vector<cv::Point>>{corner}, cv::Scalar(0));
    return with_mirrored_surface(test::LearningImage(3, map));
  };
  const test::LearningImage plate = plate_without_tips(24, 20);
  const test::LearningImage seen = test::mirrored(plate_without_tips(20, 24));
  const prepared::PreparedObject object(test::object_from(plate, reference_),
                                        prepared::Engine::kFast);
  const scene::SceneImage scene(scene_with(seen, truth_), object.top_level());
  EXPECT_TRUE(judged_of(object, scene, truth_).mirror_alternative);
}

TEST_F(VerificationTest, AMirroredTemplateFitsTheMirroredImageAsWell) {
  const cv::Mat image = scene_with(source_, truth_);
  cv::Mat flipped;
  cv::flip(image, flipped, 1);
  const Pose2D here = anchor_at(truth_);
  const Pose2D there{image.cols - 1 - here.x, here.y, -here.theta};
  templates::PoseTemplate mirrored = view_.fine;
  mirrored.mirror();
  const auto own = evidence::gather_evidence(view_.fine, scene::SceneLevel(image, 0), here);
  const auto other = evidence::gather_evidence(mirrored, scene::SceneLevel(flipped, 0), there);
  EXPECT_NEAR(other.contour_score, own.contour_score, 0.02);
  EXPECT_NEAR(other.gradient, own.gradient, 0.01);
  EXPECT_NEAR(other.trimmed_residual, own.trimmed_residual, 0.01);
  EXPECT_NEAR(other.shading_free_ncc, own.shading_free_ncc, 0.01);
}

// The lamp's highlight is at another place on the object than in the lesson.
TEST_F(VerificationTest, APlainSurfaceDoesNotDriftAlongItsShading) {
  const cv::Point2d spot(50, 75);
  const auto shaded = [&](cv::Point2d bright) {
    test::LearningImage plain = source_;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 120; ++x) {
        const double off = cv::norm(cv::Point2d(x, y) - bright) / 18;
        plain.surface.at<cv::Vec3b>(y, x) =
            cv::Vec3b::all(cv::saturate_cast<uchar>(90 + 80 * std::exp(-off * off)));
      }
    plain.surface.copyTo(plain.image, plain.map);
    return plain;
  };
  const prepared::PreparedObject object(test::object_from(shaded(spot), reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const Pose2D anchor = compose(truth_, inverse(view.reference_in_anchor));
  for (const cv::Point2d off : {cv::Point2d(8, 0), {0, 8}}) {
    const scene::SceneImage scene(scene_with(shaded(spot + off), truth_), object.top_level());
    const search::PoseHypothesis found = search::multistart_align(view, scene, anchor);
    EXPECT_LT(cv::norm(found.pose.position() - anchor.position()), 0.5) << off;
  }
}

// The colours are right except in one compact part.
TEST_F(VerificationTest, APartOfAnotherColourIsDetected) {
  test::LearningImage chequered = source_;
  for (int y = 0; y < 120; y += 6)
    for (int x = y / 6 % 2 * 6; x + 6 <= 120; x += 12)
      chequered.surface(cv::Rect(x, y, 6, 6)) = cv::Scalar(40, 40, 170);
  chequered.surface.copyTo(chequered.image, chequered.map);
  const prepared::PreparedObject object(test::object_from(chequered, reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const auto difference_in = [&](const test::LearningImage& shown) {
    const scene::SceneImage scene(scene_with(shown, truth_), object.top_level());
    search::PoseHypothesis hypothesis =
        search::score_as_is(view, scene, compose(truth_, inverse(view.reference_in_anchor)));
    hypothesis.odds = 12;
    return search::verify(object, view, scene, {hypothesis}).at(0).print_difference;
  };
  EXPECT_LT(difference_in(chequered), 0.05);
  test::LearningImage tinted = chequered;
  cv::Mat part = tinted.surface(cv::Rect(35, 25, 24, 30));
  cv::multiply(part, cv::Scalar(0.4, 1, 0.4), part);
  EXPECT_GT(difference_in(tinted), 3);
}

}  // namespace
}  // namespace mbncc
