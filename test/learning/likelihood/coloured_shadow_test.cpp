// SPDX-License-Identifier: BSD-3-Clause
// On a green cloth, a dark green patch is shadow; a grey patch, or a patch that is dark green
// throughout, is an object.
#include "learning/likelihood/coloured_shadow.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/change_cut.hpp"

namespace mbncc::likelihood {
namespace {

const cv::Size kSize(200, 160);
const cv::Scalar kCloth(150, 170, 30), kGrey(130, 130, 130);
const cv::Rect kObject(90, 60, 44, 40);
const cv::Rect kBesideObject(64, 66, 60, 34);  // partly under the object

cv::Mat plain(const cv::Scalar& colour) {
  return cv::Mat(kSize, CV_32FC3, colour);
}

// Fraction of the patch that counts as shadow if it shows `colour` on `platform`.
double shadow_part(const cv::Scalar& colour, const cv::Scalar& platform) {
  const cv::Mat shadow = coloured_shadow(plain(colour), plain(platform), 3);
  return cv::countNonZero(shadow) / static_cast<double>(shadow.total());
}

TEST(ColouredShadow, HasTheColourOfTheDarkerPlatform) {
  EXPECT_EQ(shadow_part(kCloth * 0.5, kCloth), 1);
  EXPECT_EQ(shadow_part(kCloth * 0.5 + cv::Scalar(4, -4, 8), kCloth), 1) << "with a tint";
  EXPECT_EQ(shadow_part(kCloth * 0.3 + cv::Scalar(40, 40, 40), kCloth), 0) << "nearly grey";
  EXPECT_EQ(shadow_part(kCloth, kCloth), 0) << "nothing changed";
  EXPECT_EQ(shadow_part(kCloth * 1.2, kCloth), 0) << "brighter";
  EXPECT_EQ(shadow_part(kCloth * 0.1, kCloth), 0) << "darker than shadows";
  EXPECT_EQ(shadow_part({60, 60, 60}, kCloth), 0) << "grey";
  EXPECT_EQ(shadow_part({30, 40, 120}, kCloth), 0) << "another hue";
}

TEST(ColouredShadow, IsMoreSaturatedOnAGlossyPlatform) {
  const cv::Scalar mat(92, 107, 79);
  EXPECT_EQ(shadow_part({55, 72, 42}, mat), 1);
  EXPECT_EQ(shadow_part({42, 72, 55}, mat), 0) << "another hue";
  EXPECT_EQ(shadow_part({30, 90, 10}, mat), 0) << "no shadow has three times the platform's chroma";
  const cv::Scalar cream(180, 215, 220);
  EXPECT_EQ(shadow_part({80, 145, 150}, cream), 1);
  EXPECT_EQ(shadow_part({100, 145, 150}, cream), 0) << "a pale object of the platform's hue";
}

TEST(ColouredShadow, IsNotDetectedOnGrey) {
  EXPECT_EQ(shadow_part(kGrey * 0.5, kGrey), 0);
  EXPECT_EQ(shadow_part(kGrey * 0.5 + cv::Scalar(1, 0, -1), kGrey + cv::Scalar(2, 0, -2)), 0)
      << "its colour is hardly more than noise";
}

cv::Mat truth() {
  cv::Mat map = cv::Mat::zeros(kSize, CV_8UC1);
  map(kObject).setTo(255);
  return map;
}

// IoU for an object on cloth with a hard shadow at its side.
double iou_of(const cv::Scalar& object, double light) {
  const cv::Mat cloth = test::texture(kSize, kCloth, 3, 4);
  cv::Mat before = cloth.clone();
  before(kBesideObject) *= light;
  before(kObject).setTo(object);
  cv::GaussianBlur(before, before, {}, 0.8);
  const cv::Mat seen = test::exposed(before, 1), after = test::exposed(cloth, 2);
  const cv::Mat changed = survey_change(seen, after).changed;
  return test::iou(change_cut(seen, after, {50, 44, 100, 72}, changed, 2, 8).map, truth());
}

TEST(ColouredShadow, IsNoPartOfAMap) {
  EXPECT_GT(iou_of({40, 40, 200}, 0.45), 0.93);
  EXPECT_GT(iou_of({235, 235, 235}, 0.45), 0.93);
}

TEST(ColouredShadow, AnObjectOfThePlatformsHueIsLearned) {
  EXPECT_GT(iou_of(kCloth * 0.45, 1), 0.93);
}

}  // namespace
}  // namespace mbncc::likelihood
