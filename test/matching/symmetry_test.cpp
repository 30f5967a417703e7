#include "matching/symmetry.hpp"

#include <gtest/gtest.h>

#include "matching/pictures.hpp"
#include "matching/prepared_object.hpp"

namespace mbncc {
namespace {

/// Symmetry measured for an object with this map, of one colour or textured.
int symmetry_of(const cv::Mat& map, bool textured) {
  test::LearningPicture source(51, map);
  if (!textured) {
    source.picture.setTo(cv::Scalar(150, 150, 150));
    source.picture.setTo(cv::Scalar(50, 90, 160), map);
  }
  const auto object = test::object_from(source, {60, 60, 0});
  return PreparedView(object->views.front(), Engine::kFast).symmetry;
}

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

TEST(Symmetry, PlainPolygonsRepeatPerCorner) {
  for (const int corners : {3, 4, 5}) EXPECT_EQ(symmetry_of(polygon(corners, 55), false), corners);
}

TEST(Symmetry, APlainBarRepeatsTwice) {
  cv::Mat map = cv::Mat::zeros(121, 121, CV_8UC1);
  map(cv::Rect(20, 48, 81, 25)) = 255;
  EXPECT_EQ(symmetry_of(map, false), 2);
}

TEST(Symmetry, APlainDiscIsRound) {
  EXPECT_EQ(symmetry_of(polygon(90, 40), false), 0);
}

TEST(Symmetry, TextureBreaksIt) {
  EXPECT_EQ(symmetry_of(polygon(4, 40), true), 1);
  EXPECT_EQ(symmetry_of(polygon(90, 40), true), 1);
}

TEST(Symmetry, AnIrregularOutlineHasNone) {
  EXPECT_EQ(symmetry_of(test::angle_map(), false), 1);
}

}  // namespace
}  // namespace mbncc
