#include "matching/selection.hpp"

#include <gtest/gtest.h>

#include "matching/pictures.hpp"

namespace mbncc {
namespace {

class SelectionTest : public ::testing::Test {
 protected:
  const test::LearningPicture source_{1};
  const PreparedObject object_{test::object_from(source_, {58, 60, 0}), Engine::kFast};
  const SearchConfig config_{};

  /// Of the only detection of a picture, known to a tenth of a pixel.
  Match match_of(double log_odds, double projected) const {
    Detection detection;
    detection.object = &object_;
    detection.view = &object_.views.front();
    detection.pose = {100, 100, 0};
    detection.covariance = cv::Matx33d::diag({0.01, 0.01, 1e-6});
    detection.log_odds = log_odds;
    detection.projected = projected;
    const auto selected = select_matches({detection}, {config_, std::nullopt, 1, {}, 0});
    return selected.matches.at(0);
  }
};

TEST_F(SelectionTest, GraspableIsWhatIsNearlyCertainOrShowsItsTexture) {
  EXPECT_TRUE(match_of(6, 0.3).graspable);
  EXPECT_TRUE(match_of(3, 0.8).graspable);
  EXPECT_FALSE(match_of(3, 0.4).graspable) << "a mirror image, perhaps";
  EXPECT_FALSE(match_of(1.5, 0.9).graspable);
}

TEST_F(SelectionTest, WhatIsNotConvincingIsNotAmbiguous) {
  EXPECT_FALSE(match_of(3, 0.4).ambiguous) << "nothing else is as likely";
}

}  // namespace
}  // namespace mbncc
