// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/contour_alternative.hpp"

#include <cmath>

#include "matching/decision/detection.hpp"
#include "matching/evidence/contour_alignment.hpp"
#include "matching/evidence/tool_fixture.hpp"
#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/search/verification.hpp"

namespace mbncc::evidence {
namespace {

class ContourAlternativeTest : public test::MatcherTest {
 protected:
  cv::Mat scene_ = test::texture({320, 240}, 77, 5);
  const Pose2D truth_{170, 120, 0.8};

  double better_than(const Pose2D& reference) const {
    const prepared::PreparedObject object(test::object_from(source_, reference_),
                                          prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    return advantage_elsewhere(view.fine.contour, scene::SceneLevel(scene_, 0),
                               compose(reference, inverse(view.reference_in_anchor)), 1);
  }

  /// The same outline with the surface displaced by `off` [px].
  test::LearningImage with_surface_moved(cv::Point2d off) const {
    test::LearningImage moved = source_;
    cv::warpAffine(source_.surface, moved.surface, cv::Matx23d(1, 0, off.x, 0, 1, off.y),
                   source_.surface.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return moved;
  }
};

TEST_F(ContourAlternativeTest, NoShiftIsBetterThanTheTrueOne) {
  test::place(scene_, source_, reference_.position(), truth_);
  EXPECT_LT(better_than(truth_), -0.1);
  EXPECT_LT(better_than({truth_.x + 0.7, truth_.y - 0.7, truth_.theta}), -0.05);
}

TEST_F(ContourAlternativeTest, TheTruePlaceIsBetterThanOneNearIt) {
  test::place(scene_, source_, reference_.position(), truth_);
  for (const cv::Point2d off : {cv::Point2d(5, 0), {-5, 0}, {0, 5}, {3, -3}})
    EXPECT_GT(better_than({truth_.x + off.x, truth_.y + off.y, truth_.theta}), 0.1) << off;
}

TEST_F(ContourAlternativeTest, TheAdvantageIsTheDifferenceOfTheAgreements) {
  test::place(scene_, source_, reference_.position(), truth_);
  const prepared::PreparedObject object(test::object_from(source_, reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const templates::ContourTemplate& contour = view.fine.contour;
  const scene::SceneLevel scene(scene_, 0);
  ContourAlignment agreement(contour, scene.whole());
  const Pose2D anchor = compose(truth_, inverse(view.reference_in_anchor));
  const double best = agreement.aligned(anchor, 1).agreement;
  const double turn = 2 / contour.radius();  // two pixels at the rim
  // Near, far, and between the positions that are tried.
  for (const cv::Point2d off : {cv::Point2d(3, 0), {0, -3.2}, {5, 5}, {-5, 3}, {3, -5}, {6, 6}})
    for (const double turned : {anchor.theta, anchor.theta + turn}) {
      const Pose2D beside{anchor.x + off.x, anchor.y + off.y, turned};
      EXPECT_GT(advantage_elsewhere(contour, scene, beside, 1), best - agreement.at(beside) - 0.02)
          << off << " turned by " << turned - anchor.theta;
    }
}

TEST_F(ContourAlternativeTest, ACandidateIsShiftedOntoTheEdges) {
  test::place(scene_, source_, reference_.position(), truth_);
  const prepared::PreparedObject object(test::object_from(source_, reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const Pose2D anchor = compose(truth_, inverse(view.reference_in_anchor));
  const templates::Candidate start{{anchor.x + 5, anchor.y - 4, anchor.theta}, 0, 0};
  const templates::Candidate shifted =
      shifted_onto_edges(view.tracked[0].contour, scene::SceneLevel(scene_, 0), start);
  EXPECT_LE(std::abs(shifted.pose.x - anchor.x), 1.01);
  EXPECT_LE(std::abs(shifted.pose.y - anchor.y), 1.01);
  EXPECT_EQ(shifted.pose.theta, anchor.theta);
  EXPECT_GT(shifted.value, 0.4) << "the agreement of the contour";
}

TEST_F(ContourAlternativeTest, APoseThatTheContourContradictsIsReported) {
  test::place(scene_, source_, reference_.position(), truth_);
  const prepared::PreparedObject object(test::object_from(source_, reference_),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const scene::SceneImage scene(scene_, object.top_level());
  const Pose2D anchor = compose(truth_, inverse(view.reference_in_anchor));
  search::PoseHypothesis beside =
      search::score_as_is(view, scene, {anchor.x + 5, anchor.y - 3, anchor.theta});
  beside.odds = 5;
  const auto judged = search::verify(object, view, scene, {beside});
  ASSERT_EQ(judged.size(), 1u);
  EXPECT_GT(judged[0].contour_alternative, 0.05) << "too much for a grasp";
}

TEST_F(ContourAlternativeTest, ASurfaceMatchAgainstTheContourIsNeverGraspable) {
  SearchConfig unlikely_too;
  unlikely_too.min_score = 0.1;
  const Matcher matcher = matcher_of({test::object_from(source_, reference_)}, unlikely_too);
  int found = 0;
  for (const cv::Point2d off : {cv::Point2d(0, 0), {4, 0}, {0, 4}, {4, 4}, {-4, 4}}) {
    cv::Mat scene = scene_.clone();
    test::place(scene, with_surface_moved(off), reference_.position(), truth_);
    const auto matches = matcher.find(scene).matches;
    if (matches.empty()) continue;
    found += off != cv::Point2d();
    EXPECT_EQ(matches[0].graspable, off == cv::Point2d()) << off;
  }
  EXPECT_GT(found, 0) << "the surface convinces";
}

class DisplacedEndTest : public test::ToolTest {
 protected:
  static constexpr int kLength = 150, kWidth = 16;

  /// A plain bar, `longer` [px] at its right end.
  static cv::Mat image_of(int longer, std::uint64_t seed) {
    cv::Mat image(150, 320, CV_8UC3, test::kTable);
    image(cv::Rect(75, 60, kLength + longer, kWidth)) = test::kSteel;
    add_noise(image, seed);
    return image;
  }

  static double advantage_in(const cv::Mat& image) {
    cv::Mat map = cv::Mat::zeros(150, 320, CV_8UC1);
    map(cv::Rect(75, 60, kLength, kWidth)) = 255;
    const prepared::PreparedObject object(object_of(image_of(0, 1), map), prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const Pose2D anchor = compose({150, 72, 0}, inverse(view.reference_in_anchor));
    return advantage_of_displaced_end(view.fine.contour, scene::SceneLevel(image, 0), anchor, 1);
  }
};

TEST_F(DisplacedEndTest, TheTaughtLengthFitsBest) {
  EXPECT_LT(advantage_in(image_of(0, 2)), 0);
}

TEST_F(DisplacedEndTest, AnotherLengthIsReported) {
  for (const int longer : {-24, -10, 9, 15, 28})
    EXPECT_GT(advantage_in(image_of(longer, 2)), kOtherLength + 0.1) << longer;
}

}  // namespace
}  // namespace mbncc::evidence
