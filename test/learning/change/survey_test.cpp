// SPDX-License-Identifier: BSD-3-Clause
// Measures of a survey of two images, and the limits beyond which a lesson ends.
#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "learning/teaching/lesson_progress.hpp"
#include "learning/teaching/lesson_region.hpp"
#include "mbncc/learning/change.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(320, 240);
const cv::Rect kPlace(100, 80, 60, 40);

cv::Mat platform() {
  return test::texture(kSize, cv::Scalar(105, 115, 120), 14, 1);
}

/// The platform, and the platform with a patch that differs by `step` [grey levels] per channel.
ChangeSurvey survey_of(double step, double noise) {
  cv::Mat patched = platform();
  patched(kPlace) += cv::Scalar::all(step);
  return survey_change(test::exposed(platform(), 11, 1, noise),
                       test::exposed(patched, 12, 1, noise));
}

TEST(Survey, MeasuresTheChangedFraction) {
  const double part = kPlace.area() / static_cast<double>(kSize.area());
  EXPECT_NEAR(survey_of(40, 2).fraction, part, 0.1 * part);
  EXPECT_EQ(survey_of(0, 2).fraction, 0);
}

TEST(Survey, NoiseIsNoChange) {
  EXPECT_LT(survey_of(0, 5).fraction, 0.001);
  EXPECT_LT(survey_of(0, 2).fraction, 0.001);
}

TEST(Survey, AStrongChangeIsDetectedAtAnyNoise) {
  const double part = kPlace.area() / static_cast<double>(kSize.area());
  const ChangeSurvey survey = survey_of(40, 8);
  EXPECT_TRUE(survey.noisy);
  EXPECT_GT(survey.fraction, 0.8 * part);
  EXPECT_FALSE(survey_of(40, 2).noisy);
}

TEST(Survey, ALargeBlackLevelCountsAsChangedLight) {
  const cv::Mat before = test::exposed(platform(), 11);
  EXPECT_GT(survey_change(before, test::exposed(platform() - cv::Scalar::all(40), 12)).exposure,
            1.4);
}

class SurveyLimits : public testing::Test {
 protected:
  bool ends_lesson(const ChangeSurvey& survey) const {
    try {
      teaching::check_camera_still(survey, config_);
      teaching::check_one_change(survey, config_);
      return false;
    } catch (const teaching::LessonEnded& ended) {
      EXPECT_EQ(ended.error(), LearnError::kChangeTooLarge);
      return true;
    }
  }

  /// A survey in which each figure has its largest tolerated value.
  ChangeSurvey most() const {
    ChangeSurvey survey;
    survey.exposure = config_.max_exposure_change;
    survey.unevenness = config_.max_light_change;
    survey.shift.x = config_.max_shift;
    survey.displaced = 0.6;
    survey.fraction = config_.max_change;
    return survey;
  }

  const LearningConfig config_{};
};

TEST_F(SurveyLimits, EachFigureHasItsLimit) {
  EXPECT_FALSE(ends_lesson(ChangeSurvey()));
  EXPECT_FALSE(ends_lesson(most()));
  ChangeSurvey light = most(), uneven = most(), moved = most(), displaced = most(),
               changed = most();
  light.exposure += 0.01;
  uneven.unevenness += 0.01;
  moved.shift.y = 1;
  displaced.displaced += 0.01;
  changed.fraction += 0.01;
  for (const ChangeSurvey& survey : {light, uneven, moved, displaced, changed})
    EXPECT_TRUE(ends_lesson(survey));
}

}  // namespace
}  // namespace mbncc
