// SPDX-License-Identifier: BSD-3-Clause
// A change that is hidden by noise in single pixels is significant in wide patches.
#include "learning/likelihood/faint_change.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/change_cut.hpp"

namespace mbncc::likelihood {
namespace {

const cv::Size kSize(120, 100);

// Squared distances of three channels of noise; `patch` deviates by `contrast` standard deviations.
cv::Mat distances(const cv::Rect& patch, float contrast) {
  cv::RNG random(3);
  cv::Mat noise(kSize, CV_32FC3), squares;
  random.fill(noise, cv::RNG::NORMAL, 0, 1);
  noise(patch) += cv::Scalar::all(contrast);
  cv::transform(noise.mul(noise), squares, cv::Matx13f(1, 1, 1));
  return squares;
}

cv::Mat faint(const cv::Mat& unchanged, const cv::Mat& shaded, double brightness) {
  const cv::Mat after(kSize, CV_32FC3, cv::Scalar::all(brightness));
  const cv::Mat variance(kSize, CV_32FC3, cv::Scalar::all(64));
  return faint_change({unchanged, shaded}, after, variance, 1, cv::Mat::zeros(kSize, CV_8UC1));
}

const cv::Rect kPatch(40, 30, 30, 30), kGap(40, 30, 30, 4);

TEST(FaintChange, AWidePatchIsDetected) {
  const cv::Mat patch = distances(kPatch, 1.2F), found = faint(patch, patch, 45);
  EXPECT_GT(cv::countNonZero(found(kPatch)), 0.7 * kPatch.area());
  EXPECT_LT(cv::countNonZero(found) - cv::countNonZero(found(kPatch)), 0.15 * kPatch.area());
}

TEST(FaintChange, NoiseAndShadowsAreNoFaintChange) {
  const cv::Mat none = distances(kPatch, 0), patch = distances(kPatch, 1.2F);
  EXPECT_EQ(cv::countNonZero(faint(none, none, 45)), 0);
  EXPECT_EQ(cv::countNonZero(faint(patch, none, 45)), 0);
}

TEST(FaintChange, IsNotDetectedInNarrowPatchesAndBrightImages) {
  const cv::Mat gap = distances(kGap, 1.2F), patch = distances(kPatch, 1.2F);
  EXPECT_LT(cv::countNonZero(faint(gap, gap, 45)), 0.2 * kGap.area());
  EXPECT_EQ(cv::countNonZero(faint(patch, patch, 200)), 0);
}

TEST(FaintChange, TheWholeObjectOfADimLessonIsLearned) {
  test::DrawnLesson drawn = test::draw_lesson();
  drawn.lesson.before = test::exposed(drawn.scene, 11, 0.4, 8);
  drawn.lesson.after = test::exposed(drawn.platform, 12, 0.4, 8);
  const ObjectCut cut =
      change_cut(drawn.lesson.before, drawn.lesson.after, drawn.lesson.region,
                 survey_change(drawn.lesson.before, drawn.lesson.after).changed, 2, 8);
  EXPECT_GT(test::iou(cut.map, drawn.truth), 0.85);
}

}  // namespace
}  // namespace mbncc::likelihood
