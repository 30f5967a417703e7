// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/symmetry.hpp"

#include <gtest/gtest.h>

#include "matching/images.hpp"
#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::prepared {
namespace {

const cv::Scalar kPlatform(150, 150, 150), kPaint(50, 90, 160);

cv::Mat polygon(int corners, double radius) {
  cv::Mat map = cv::Mat::zeros(121, 121, CV_8UC1);
  std::vector<cv::Point> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 0.2 + 2 * kPi * k / corners;
    points.emplace_back(cvRound(16 * (60 + radius * std::cos(angle))),
                        cvRound(16 * (60 + radius * std::sin(angle))));
  }
  cv::fillPoly(map, std::vector<std::vector<cv::Point>>{points}, cv::Scalar(255), cv::LINE_8, 4);
  return map;
}

cv::Mat disc() {
  return polygon(90, 40);
}

cv::Mat bar() {
  cv::Mat map = cv::Mat::zeros(121, 121, CV_8UC1);
  map(cv::Rect(20, 45, 81, 31)) = 255;
  return map;
}

/// A plain object on a plain platform.
cv::Mat painted(const cv::Mat& map) {
  cv::Mat image(map.size(), CV_8UC3, kPlatform);
  image.setTo(kPaint, map);
  return image;
}

/// The image as a camera sees it: blurred, lit from one side, with noise.
cv::Mat photographed(const cv::Mat& image, double noise = 2, int seed = 7) {
  cv::Mat light, result;
  image.convertTo(light, CV_32F);
  cv::GaussianBlur(light, light, {}, 0.7);
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x)
      light.at<cv::Vec3f>(y, x) *= 1 + 0.2f * static_cast<float>(x + y - 120) / 120.f;
  cv::Mat grains(light.size(), CV_32FC3);
  cv::RNG(seed).fill(grains, cv::RNG::NORMAL, 0, noise);
  light += grains;
  light.convertTo(result, CV_8U);
  return result;
}

MeasuredSymmetry measured(const cv::Mat& image, const cv::Mat& map) {
  return measure_symmetry(crop_view(image, map, {60, 60, 0}));
}

TEST(Symmetry, PlainPolygonsRepeatPerCorner) {
  for (const int corners : {3, 4, 5, 6}) {
    const cv::Mat map = polygon(corners, 50);
    EXPECT_EQ(measured(painted(map), map).certain, corners);
  }
}

TEST(Symmetry, APlainBarRepeatsTwice) {
  EXPECT_EQ(measured(painted(bar()), bar()).certain, 2);
}

TEST(Symmetry, APlainDiscIsRound) {
  EXPECT_EQ(measured(painted(disc()), disc()).certain, 0);
}

TEST(Symmetry, IsMeasuredUnderLightAndCameraNoise) {
  EXPECT_EQ(measured(photographed(painted(bar())), bar()).certain, 2);
  EXPECT_EQ(measured(photographed(painted(disc())), disc()).certain, 0);
  EXPECT_EQ(measured(photographed(painted(polygon(6, 50))), polygon(6, 50)).certain, 6);
}

TEST(Symmetry, TextureBreaksTheSymmetry) {
  const cv::Mat square = polygon(4, 40);
  EXPECT_EQ(measured(test::LearningImage(51, square).image, square).possible, 1);
}

// Print, an oblique side and gloss look alike in one image, so only the operator can decide.
TEST(Symmetry, ARoundOutlineWithAnyTextureIsLeftToTheOperator) {
  const MeasuredSymmetry symmetry = measured(test::LearningImage(51, disc()).image, disc());
  EXPECT_EQ(symmetry.certain, 1);
  EXPECT_EQ(symmetry.possible, 0);
}

TEST(Symmetry, AnIrregularOutlineHasNoSymmetry) {
  const MeasuredSymmetry symmetry = measured(painted(test::angle_map()), test::angle_map());
  EXPECT_EQ(symmetry.certain, 1);
  EXPECT_EQ(symmetry.possible, 1);
}

// A dot of 1 % of the area, which a person notices at once.
TEST(Symmetry, ASmallMarkIsLeftToTheOperator) {
  for (const double contrast : {20., 35.}) {
    cv::Mat marked_bar = painted(bar()), marked_disc = painted(disc());
    const cv::Scalar mark = kPaint + cv::Scalar::all(contrast);
    cv::circle(marked_bar, {85, 60}, 3, mark, cv::FILLED);
    cv::circle(marked_disc, {82, 60}, 4, mark, cv::FILLED);
    const MeasuredSymmetry of_bar = measured(photographed(marked_bar), bar());
    EXPECT_EQ(of_bar.certain, 1) << contrast;
    EXPECT_EQ(of_bar.possible, 2) << contrast;
    const MeasuredSymmetry of_disc = measured(photographed(marked_disc), disc());
    EXPECT_EQ(of_disc.certain, 1) << contrast;
    EXPECT_EQ(of_disc.possible, 0) << contrast;
  }
}

TEST(Symmetry, ANotchIsLeftToTheOperator) {
  cv::Mat map = bar();
  map(cv::Rect(98, 57, 3, 7)) = 0;  // 1 % of the area
  const MeasuredSymmetry symmetry = measured(photographed(painted(map)), map);
  EXPECT_EQ(symmetry.certain, 1);
  EXPECT_EQ(symmetry.possible, 2);
}

// Half of the bar is slightly lighter: there is no edge, but the ends differ.
TEST(Symmetry, AnEndOfAnotherShadeIsLeftToTheOperator) {
  cv::Mat image = painted(bar());
  image(cv::Rect(86, 45, 15, 31)).setTo(kPaint + cv::Scalar::all(25));
  EXPECT_EQ(measured(photographed(image), bar()).certain, 1);
}

// The differences are too small for a mark, but too large for noise.
TEST(Symmetry, FineGrainBreaksTheSymmetry) {
  cv::Mat grain(121, 121, CV_32FC3), image;
  cv::RNG(3).fill(grain, cv::RNG::NORMAL, 0, 12);
  painted(bar()).convertTo(image, CV_32F);
  cv::add(image, grain, image, bar());
  image.convertTo(image, CV_8U);
  EXPECT_EQ(measured(image, bar()).certain, 1);
  EXPECT_EQ(measured(image, bar()).possible, 2);
}

TEST(Symmetry, ATaperedOutlineIsLeftToTheOperator) {
  cv::Mat map = cv::Mat::zeros(121, 121, CV_8UC1);
  const std::vector<cv::Point> corners{{20, 44}, {100, 46}, {100, 74}, {20, 76}};
  cv::fillPoly(map, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  const MeasuredSymmetry symmetry = measured(photographed(painted(map)), map);
  EXPECT_EQ(symmetry.certain, 1);
  EXPECT_EQ(symmetry.possible, 2);
}

// The centroid of a map is no more accurate than its edge, so the surface determines the centre.
TEST(Symmetry, IsMeasuredOnARoughMap) {
  cv::Mat image = painted(bar());
  for (int x = 27; x < 60; x += 8) {
    image(cv::Rect(x, 50, 4, 12)).setTo(cv::Scalar::all(230));
    image(cv::Rect(120 - x - 3, 120 - 50 - 11, 4, 12)).setTo(cv::Scalar::all(230));
  }
  cv::Mat map = bar();
  EXPECT_EQ(measured(photographed(image, 1), map).certain, 2);
  map.colRange(0, 22) = 0;
  EXPECT_EQ(measured(photographed(image, 1), map).certain, 2);
}

TEST(Symmetry, GlossIsLeftToTheOperator) {
  cv::Mat gloss = cv::Mat::zeros(121, 121, CV_8UC1), image = painted(disc());
  cv::circle(gloss, {50, 48}, 6, cv::Scalar(40), cv::FILLED);
  cv::GaussianBlur(gloss, gloss, {}, 2);
  cv::Mat added;
  cv::cvtColor(gloss, added, cv::COLOR_GRAY2BGR);
  const MeasuredSymmetry symmetry = measured(photographed(image + added), disc());
  EXPECT_EQ(symmetry.certain, 1);
  EXPECT_EQ(symmetry.possible, 0);
}

TEST(Symmetry, ADeclaredSymmetryOverridesTheMeasurement) {
  auto model = std::make_shared<ObjectModel>();
  model->name = "bar";
  model->views = {crop_view(painted(bar()), bar(), {60, 60, 0})};
  EXPECT_EQ(PreparedObject(model, Engine::kFast).views.front().symmetry, 2);
  for (const int declared : {0, 1, 2, 5, 12}) {
    model->symmetry = declared;
    for (const auto& view : PreparedObject(model, Engine::kFast, 0.1).views)
      EXPECT_EQ(view.symmetry, declared);
  }
  model->symmetry = 13;
  EXPECT_THROW(PreparedObject(model, Engine::kFast), std::invalid_argument);
}

/// A bar with a faint mark, whose symmetry is left to the operator, in another image of the scene
/// in which it was learned.
class MarkedBar : public test::MatcherTest {
 protected:
  Match found(const cv::Mat& map, std::optional<int> declared, int noise = 8) {
    cv::Mat image(240, 240, CV_8UC3, kPlatform), whole = cv::Mat::zeros(240, 240, CV_8UC1);
    const cv::Rect place(60, 60, map.cols, map.rows);
    cv::Mat object = painted(map);
    cv::circle(object, {85, 60}, 3, kPaint + cv::Scalar::all(20), cv::FILLED);
    photographed(object).copyTo(image(place));
    map.copyTo(whole(place));
    auto model = std::make_shared<ObjectModel>();
    model->name = "marked";
    model->views = {crop_view(image, whole, {120, 120, 0})};
    model->symmetry = declared;
    photographed(object, 2, noise).copyTo(image(place));
    const auto matches = matcher_of({model}).find(image).matches;
    EXPECT_EQ(matches.size(), 1u);
    return matches.empty() ? Match() : matches.front();
  }
};

TEST_F(MarkedBar, IsGraspableAtBothAnglesIfDeclaredSymmetric) {
  for (const int noise : {8, 9, 10, 11, 12}) {
    const Match undeclared = found(bar(), std::nullopt, noise);
    EXPECT_EQ(undeclared.symmetry, 1) << noise;
    EXPECT_FALSE(undeclared.graspable) << noise;
    EXPECT_TRUE(undeclared.ambiguous) << noise;
  }
  const Match declared = found(bar(), 2);
  EXPECT_EQ(declared.symmetry, 2);
  EXPECT_TRUE(declared.graspable);
  EXPECT_FALSE(declared.ambiguous);
}

TEST_F(MarkedBar, AMarkedDiscIsGraspableAtAnyAngleIfDeclaredRound) {
  for (const int noise : {8, 9, 10, 11, 12}) {
    const Match undeclared = found(disc(), std::nullopt, noise);
    EXPECT_EQ(undeclared.symmetry, 1) << noise;
    EXPECT_FALSE(undeclared.graspable) << noise;
  }
  const Match declared = found(disc(), 0);
  EXPECT_EQ(declared.symmetry, 0);
  EXPECT_TRUE(declared.graspable);
}

// A wrong declaration of a bar's symmetry does not add angles.
TEST_F(MarkedBar, DeclaredNoneKeepsTheAngleStrict) {
  cv::Mat plain = painted(bar());
  auto model = std::make_shared<ObjectModel>();
  model->name = "plain";
  model->views = {crop_view(plain, bar(), {60, 60, 0})};
  EXPECT_EQ(measure_symmetry(model->views.front()).certain, 2);
  cv::Mat image(240, 240, CV_8UC3, kPlatform);
  photographed(plain).copyTo(image(cv::Rect(60, 60, 121, 121)));
  EXPECT_TRUE(matcher_of({model}).find(image).matches.at(0).graspable);
  model->symmetry = 1;
  EXPECT_FALSE(matcher_of({model}).find(image).matches.at(0).graspable);
}

// The region selects what is reported, not what competes.
TEST_F(MarkedBar, AnAngleWhoseReferencePointLiesOutsideTheRegionCompetes) {
  cv::Mat plain = painted(bar());
  auto model = std::make_shared<ObjectModel>();
  model->name = "plain";
  model->views = {crop_view(plain, bar(), {25, 60, 0})};
  model->symmetry = 1;
  cv::Mat image(240, 240, CV_8UC3, kPlatform);
  photographed(plain).copyTo(image(cv::Rect(60, 60, 121, 121)));
  int reported = 0;
  for (const int end : {85, 155}) {
    SearchRequest request;
    request.roi = cv::Rect(end - 10, 110, 20, 20);
    for (const auto& match : matcher_of({model}).find(image, request).matches) {
      ++reported;
      EXPECT_TRUE(request.roi.contains(match.pose.position()));
      EXPECT_TRUE(match.ambiguous);
      EXPECT_LT(match.margin_angle, 3);
    }
  }
  EXPECT_EQ(reported, 1) << "the angle that the whole image reports, in the region of its end";
}

}  // namespace
}  // namespace mbncc::prepared
