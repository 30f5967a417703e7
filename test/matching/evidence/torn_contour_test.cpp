// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/torn_contour.hpp"

#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/search/verification.hpp"

namespace mbncc::evidence {
namespace {

using test::torn;

class TornContourTest : public test::MatcherTest {
 protected:
  TornContourTest() { test::place(scene_, source_, reference_.position(), truth_); }

  Pose2D anchor_at(const Pose2D& pose) const {
    return compose(pose, inverse(view_.reference_in_anchor));
  }

  double better(const cv::Mat& image, const Pose2D& pose) const {
    return advantage_torn(view_.fine.contour, scene::SceneLevel(image, 0), anchor_at(pose), 1);
  }

  cv::Mat scene_ = test::texture({320, 240}, 77, 5);
  const Pose2D truth_{170, 120, 1.5};
  const prepared::PreparedObject object_{test::object_from(source_, reference_),
                                         prepared::Engine::kFast};
  const prepared::PreparedView& view_ = object_.views.front();
};

TEST_F(TornContourTest, AnIntactObjectIsNotTorn) {
  for (const cv::Point2d off : {cv::Point2d(0, 0), {1, 0}, {0, -1}})
    for (const double turn : {-0.02, 0., 0.02})
      EXPECT_LT(better(scene_, {truth_.x + off.x, truth_.y + off.y, truth_.theta + turn}), kTorn);
}

TEST_F(TornContourTest, DisplacedPartsAreDetected) {
  const int middle = cvRound(anchor_at(truth_).y);
  for (const int from : {middle - 12, middle, middle + 12})
    for (const double way : {-8., -5., 5., 8.})
      for (const double part : {0., 0.5, 1.})
        EXPECT_GT(better(torn(scene_, from, way), {truth_.x + part * way, truth_.y, truth_.theta}),
                  kTorn)
            << "from " << from << " by " << way << ", found at " << part;
}

// The pose that fits both parts best.
TEST_F(TornContourTest, IsDetectedForARotatedPoseBetweenTheParts) {
  constexpr double kWay = 8;
  const Pose2D anchor = anchor_at(truth_);
  const cv::Mat image = torn(scene_, cvRound(anchor.y), kWay);
  for (const double turn : {-0.09, 0.09}) {
    const Pose2D between{anchor.x + kWay / 2, anchor.y, anchor.theta + turn};
    EXPECT_GT(advantage_torn(view_.fine.contour, scene::SceneLevel(image, 0), between, 1), 0.2)
        << turn;
  }
}

TEST_F(TornContourTest, IsReportedInTheDetection) {
  const Pose2D anchor = anchor_at(truth_);
  const int middle = cvRound(anchor.y);
  const auto is_torn = [&](const cv::Mat& image, double way) {
    const scene::SceneImage scene(image, object_.top_level());
    search::PoseHypothesis found =
        search::score_as_is(view_, scene, {anchor.x + way / 2, anchor.y, anchor.theta});
    found.odds = 12;
    return search::verify(object_, view_, scene, {found}).at(0).torn;
  };
  EXPECT_FALSE(is_torn(scene_, 0));
  EXPECT_TRUE(is_torn(torn(scene_, middle, 6), 6));
  constexpr double kWay = 7;
  cv::Mat later = test::texture(scene_.size(), 77, 5), image = scene_.clone();
  test::place(later, source_, reference_.position(), {truth_.x + kWay, truth_.y, truth_.theta});
  later.rowRange(middle, later.rows).copyTo(image.rowRange(middle, image.rows));
  EXPECT_TRUE(is_torn(image, kWay)) << "by the outline, before a background that rests";
}

/// A narrow object, rotated slightly, fits both of its torn parts about as well.
TEST(TornBar, IsDetectedByTheRowsOfTheImage) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1), image = test::texture({320, 240}, 77, 5);
  map(cv::Rect(52, 15, 16, 90)) = 255;
  const test::LearningImage source(1, map);
  const Pose2D reference{60, 60, 0}, truth{170, 120, 0};
  test::place(image, source, reference.position(), truth);
  const prepared::PreparedObject object(test::object_from(source, reference),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  for (const double way : {0., 4.}) {
    const Pose2D between{truth.x + way / 2, truth.y, truth.theta - way / 90};
    const scene::SceneImage scene(torn(image, 120, way), object.top_level());
    search::PoseHypothesis found =
        search::score_as_is(view, scene, compose(between, inverse(view.reference_in_anchor)));
    found.odds = 12;
    EXPECT_EQ(search::verify(object, view, scene, {found}).at(0).torn, way > 0) << way;
  }
}

}  // namespace
}  // namespace mbncc::evidence
