// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "learning/images.hpp"
#include "learning/teaching/lesson_checks.hpp"
#include "mbncc/learning/change.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::DrawnLesson;

ObjectModel model_of(const cv::Mat& image, const cv::Mat& map) {
  const cv::Point2d centre = centroid(map);
  ObjectModel object;
  object.name = "thing";
  object.views = {crop_view(image, map, {centre.x, centre.y, 0})};
  return object;
}

Quality quality_of(const cv::Mat& image, const cv::Mat& map,
                   const std::optional<CutEvidence>& evidence = std::nullopt) {
  return assess_quality(model_of(image, map), image, cv::Mat(), evidence, {}, {});
}

bool has_reason(const Quality& quality, const std::string& key) {
  return std::find(quality.reasons.begin(), quality.reasons.end(), key) != quality.reasons.end();
}

cv::Mat disc_map(cv::Size size, cv::Point centre, int radius) {
  cv::Mat map = cv::Mat::zeros(size, CV_8UC1);
  cv::circle(map, centre, radius, cv::Scalar(255), cv::FILLED);
  return map;
}

TEST(Quality, IsGoodForAGoodMap) {
  const DrawnLesson drawn = draw_lesson();
  const Quality quality = quality_of(drawn.lesson.before, drawn.truth);
  EXPECT_EQ(quality.verdict, Verdict::kGood);
  EXPECT_TRUE(quality.reasons.empty());
  EXPECT_EQ(quality.area, cv::countNonZero(drawn.truth));
  EXPECT_GT(quality.fill, 0.3);
  EXPECT_LT(quality.fill, 0.9);
  EXPECT_NEAR(quality.contrast, 22, 8);
  EXPECT_GT(quality.edge_agreement, 0.7);
  EXPECT_TRUE(std::isnan(quality.change_agreement)) << "there was no image after";
  EXPECT_GT(quality.self_score, 0.9);
  EXPECT_LT(quality.self_error, 0.2);
  EXPECT_LT(quality.runner_up, 0.5);
  EXPECT_GT(quality.angle_halfwidth, 0);
  EXPECT_LT(quality.angle_halfwidth, to_radians(60));
  EXPECT_EQ(quality.symmetry, 1);
  EXPECT_GT(quality.search_time, 0);
}

TEST(Quality, AFarSpeckInAGivenMapIsNotGood) {
  const DrawnLesson drawn = draw_lesson();
  cv::Mat map = drawn.truth.clone();
  const cv::Rect speck(3, 5, 3, 3);
  ASSERT_EQ(cv::countNonZero(map(speck)), 0);
  map(speck).setTo(255);
  const Quality quality = quality_of(drawn.lesson.before, map);
  EXPECT_EQ(quality.verdict, Verdict::kMarginal);
  ASSERT_TRUE(has_reason(quality, "detached_part"));
  EXPECT_EQ(quality.reasons.front(), "detached_part") << "the worst first";
  EXPECT_EQ(quality.reasons.size(), quality.advice.size());
  EXPECT_NE(quality.advice.front().find("of 9 px at x 4, y 6 enlarges"), std::string::npos)
      << quality.advice.front();
  EXPECT_FALSE(has_reason(quality_of(drawn.lesson.before, map, CutEvidence()), "detached_part"))
      << "of a cut, it belongs to the object";
}

TEST(Quality, ChangeAgreesWithTheTrueMap) {
  const DrawnLesson drawn = draw_lesson();
  const Quality quality = assess_quality(
      model_of(drawn.lesson.before, drawn.truth), drawn.lesson.before,
      survey_change(drawn.lesson.before, drawn.lesson.after).changed, std::nullopt, {}, {});
  EXPECT_GT(quality.change_agreement, 0.7);
}

// The angle of a round object is arbitrary, and with it the place of a reference point beside it.
TEST(Quality, TheFrameOfARoundObjectDoesNotMatter) {
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar::all(150));
  cv::randn(image, cv::Scalar::all(150), cv::Scalar::all(2));
  const cv::Mat map = disc_map(image.size(), {160, 120}, 30);
  image.setTo(cv::Scalar(50, 90, 160), map);
  ObjectModel model = model_of(image, map);
  model.symmetry = 0;
  model.views.front().reference.x += 90;
  const Quality quality = assess_quality(model, image, cv::Mat(), std::nullopt, {}, {});
  EXPECT_GT(quality.self_score, 0.9);
  EXPECT_LT(quality.runner_up, 0.5);
}

TEST(Quality, ADiscFillsItsExcircle) {
  const DrawnLesson drawn = draw_lesson();
  const Quality quality =
      quality_of(drawn.lesson.before, disc_map(drawn.truth.size(), {120, 100}, 30));
  EXPECT_NEAR(quality.fill, 1, 0.05);
}

// Each signal raises the risk; the limits are those of the verdict.
TEST(Quality, TheSignalsOfTheCutLowerTheOutlineProbability) {
  const DrawnLesson drawn = draw_lesson();
  const ObjectModel object = model_of(drawn.lesson.before, drawn.truth);
  const auto judged = [&](const CutEvidence& evidence) {
    return assess_quality(object, drawn.lesson.before, {}, evidence, {}, {});
  };
  const Quality good = judged({});
  EXPECT_EQ(good.verdict, Verdict::kGood);
  EXPECT_GT(good.outline_probability, 0.85);
  CutEvidence unstable, weak, beside, unverified;
  unstable.stability = 0.8;
  weak.boundary_contrast = 0.3;
  beside.change_outside = 0.09;
  unverified.verified = false;
  for (const CutEvidence& evidence : {unstable, weak, beside, unverified})
    EXPECT_LT(judged(evidence).outline_probability, good.outline_probability);
  EXPECT_EQ(judged(unstable).verdict, Verdict::kMarginal);
  EXPECT_TRUE(has_reason(judged(unstable), "unstable_cut"));
  unstable.stability = 0.6;
  EXPECT_EQ(judged(unstable).verdict, Verdict::kBad);
  EXPECT_EQ(judged(unverified).verdict, Verdict::kMarginal);
  unverified.region_span = 0.1;
  unverified.boundary_contrast = 0.6;
  EXPECT_LT(judged(unverified).outline_probability, 0.75);
  EXPECT_TRUE(has_reason(judged(unverified), "little_of_region"));
}

TEST(Quality, AShiftedMapHasLessEdgeSupport) {
  const DrawnLesson drawn = draw_lesson();
  cv::Mat shifted = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  drawn.truth(cv::Rect(0, 0, 200, 160)).copyTo(shifted(cv::Rect(40, 40, 200, 160)));
  EXPECT_LT(quality_of(drawn.lesson.before, shifted).edge_agreement,
            quality_of(drawn.lesson.before, drawn.truth).edge_agreement);
}

// The twin will be found as well; this is reported, but it is not a fault of the map.
TEST(Quality, ASecondObjectOfTheSameLookIsReported) {
  DrawnLesson drawn = draw_lesson({60, 60}, {320, 240});
  cv::Mat twin = drawn.lesson.before(cv::Rect(10, 20, 100, 80)).clone();
  twin.copyTo(drawn.lesson.before(cv::Rect(180, 130, 100, 80)));
  const Quality quality = quality_of(drawn.lesson.before, drawn.truth);
  EXPECT_TRUE(has_reason(quality, "not_distinct"));
  EXPECT_EQ(quality.verdict, Verdict::kGood);
  EXPECT_FALSE(
      has_reason(quality_of(draw_lesson().lesson.before, draw_lesson().truth), "not_distinct"));
}

TEST(Quality, SymmetriesAreReportedButNoFault) {
  const cv::Size size(240, 200);
  cv::Mat image = test::exposed(test::texture(size, cv::Scalar(110, 110, 110), 10, 5), 6);
  // A bar whose right half is its left half rotated by 180 degrees.
  const cv::Rect bar(70, 80, 100, 41), left(70, 80, 50, 41), right(120, 80, 50, 41);
  cv::Mat map = cv::Mat::zeros(size, CV_8UC1), turned;
  map(bar).setTo(255);
  test::exposed(test::texture(left.size(), cv::Scalar(60, 90, 190), 40, 7), 8).copyTo(image(left));
  cv::rotate(image(left), turned, cv::ROTATE_180);
  turned.copyTo(image(right));
  const Quality quality = quality_of(image, map);
  EXPECT_EQ(quality.symmetry, 2);
  EXPECT_TRUE(has_reason(quality, "symmetric_180"));
  EXPECT_EQ(quality.verdict, Verdict::kGood);
}

// The disc's mark shows its angle: the near symmetry is reported, but not used.
TEST(Quality, NearSymmetriesAreProposedUntilDeclared) {
  const cv::Size size(240, 200);
  cv::Mat scene(size, CV_32FC3, cv::Scalar::all(110)), map = disc_map(size, {120, 100}, 40);
  scene.setTo(cv::Scalar(60, 90, 190), map);
  cv::circle(scene, {140, 100}, 4, cv::Scalar(90, 120, 220), cv::FILLED);
  cv::GaussianBlur(scene, scene, {}, 0.7);
  const cv::Mat image = test::exposed(scene, 6);
  const Quality quality = quality_of(image, map);
  EXPECT_EQ(quality.symmetry, 1);
  ASSERT_TRUE(has_reason(quality, "nearly_round"));
  EXPECT_EQ(quality.reasons.size(), quality.advice.size());
  EXPECT_NE(quality.advice.back().find("declare symmetry round"), std::string::npos);
  EXPECT_EQ(teaching::error_of(quality), LearnError::kSuccess);

  ObjectModel object = model_of(image, map);
  for (const int declared : {1, 0}) {
    object.symmetry = declared;
    const Quality told = assess_quality(object, image, cv::Mat(), std::nullopt, {}, {});
    EXPECT_EQ(told.symmetry, declared);
    EXPECT_FALSE(has_reason(told, "nearly_round"));
    EXPECT_EQ(has_reason(told, "round"), declared == 0);
  }
}

TEST(Quality, RoundObjectsHaveNoAngle) {
  const cv::Size size(240, 200);
  cv::Mat image = test::exposed(test::texture(size, cv::Scalar(110, 110, 110), 10, 5), 6);
  for (int radius = 40; radius > 0; radius -= 10)
    cv::circle(image, {120, 100}, radius, cv::Scalar::all(radius % 20 == 0 ? 220 : 40), cv::FILLED);
  const Quality quality = quality_of(image, disc_map(size, {120, 100}, 40));
  EXPECT_EQ(quality.symmetry, 0);
  EXPECT_TRUE(has_reason(quality, "round"));
}

// Every weakness of a cut is reported; none improves the verdict.
TEST(Quality, EvidenceAgainstTheCutIsNamed) {
  const DrawnLesson drawn = draw_lesson();
  const auto verdict_with = [&](const CutEvidence& evidence, const char* key) {
    const Quality quality = quality_of(drawn.lesson.before, drawn.truth, evidence);
    EXPECT_TRUE(has_reason(quality, key)) << key;
    EXPECT_EQ(quality.reasons.size(), quality.advice.size());
    return quality.verdict;
  };
  CutEvidence touch, outside, unstable, weak;
  touch.cut_off = 0.5;
  outside.change_outside = 0.8;
  unstable.stability = 0.1;
  weak.boundary_contrast = 0.05;
  EXPECT_NE(verdict_with(touch, "touches_region_edge"), Verdict::kGood);
  EXPECT_NE(verdict_with(outside, "change_outside_region"), Verdict::kGood);
  CutEvidence beside;
  beside.change_beside = 0.15;
  EXPECT_EQ(verdict_with(beside, "change_left_out"), Verdict::kMarginal);
  EXPECT_NE(verdict_with(unstable, "unstable_cut"), Verdict::kGood);
  EXPECT_NE(verdict_with(weak, "weak_boundary"), Verdict::kGood);
}

}  // namespace
}  // namespace mbncc
