// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/torn_contour.hpp"

#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/search/verification.hpp"

namespace mbncc::evidence {
namespace {

class TornOutline : public test::MatcherTest {
 protected:
  TornOutline() { test::place(scene_, source_, reference_.position(), truth_); }

  /// Rows from `from` on are displaced by `way` [px].
  static cv::Mat torn(const cv::Mat& image, int from, double way) {
    cv::Mat moved, result = image.clone();
    cv::warpAffine(image, moved, cv::Matx23d(1, 0, way, 0, 1, 0), image.size(), cv::INTER_LINEAR,
                   cv::BORDER_REPLICATE);
    moved.rowRange(from, moved.rows).copyTo(result.rowRange(from, moved.rows));
    return result;
  }

  Pose2D anchor_at(const Pose2D& pose) const {
    return compose(pose, inverse(view_.reference_in_anchor));
  }

  double better(const cv::Mat& image, const Pose2D& pose) const {
    return better_torn(view_.fine.contour, scene::SceneLevel(image, 0), anchor_at(pose), 1);
  }

  cv::Mat scene_ = test::texture({320, 240}, 77, 5);
  const Pose2D truth_{170, 120, 1.5};
  const prepared::PreparedObject object_{test::object_from(source_, reference_),
                                         prepared::Engine::kFast};
  const prepared::PreparedView& view_ = object_.views.front();
};

TEST_F(TornOutline, WhatLiesTogetherIsNotTorn) {
  for (const cv::Point2d off : {cv::Point2d(0, 0), {1, 0}, {0, -1}})
    for (const double turn : {-0.02, 0., 0.02})
      EXPECT_LT(better(scene_, {truth_.x + off.x, truth_.y + off.y, truth_.theta + turn}), kTorn);
}

TEST_F(TornOutline, PartsThatLieApartAreTold) {
  const int middle = cvRound(anchor_at(truth_).y);
  for (const int from : {middle - 12, middle, middle + 12})
    for (const double way : {-8., -5., 5., 8.})
      for (const double part : {0., 0.5, 1.})
        EXPECT_GT(better(torn(scene_, from, way), {truth_.x + part * way, truth_.y, truth_.theta}),
                  kTorn)
            << "from " << from << " by " << way << ", found at " << part;
}

// The pose that suits both parts best.
TEST_F(TornOutline, ItIsToldOfWhatLiesTurnedBetweenTheParts) {
  constexpr double kWay = 8;
  const Pose2D anchor = anchor_at(truth_);
  const cv::Mat image = torn(scene_, cvRound(anchor.y), kWay);
  for (const double turn : {-0.09, 0.09}) {
    const Pose2D between{anchor.x + kWay / 2, anchor.y, anchor.theta + turn};
    EXPECT_GT(better_torn(view_.fine.contour, scene::SceneLevel(image, 0), between, 1), 0.2)
        << turn;
  }
}

TEST_F(TornOutline, ADetectionKnows) {
  const Pose2D anchor = anchor_at(truth_);
  for (const double way : {0., 6.}) {
    const scene::SceneImage scene(torn(scene_, cvRound(anchor.y), way), object_.top_level());
    search::PoseHypothesis found =
        search::score_as_is(view_, scene, {anchor.x + way / 2, anchor.y, anchor.theta});
    found.odds = 12;
    EXPECT_EQ(search::verify(object_, view_, scene, {found}).at(0).torn, way > 0);
  }
}

}  // namespace
}  // namespace mbncc::evidence
