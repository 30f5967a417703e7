// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/moved_neighbour.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::change {
namespace {

constexpr float kSigma = 2.8F;  // of the difference of two exposed() images
const cv::Size kSize(240, 200);
const cv::Rect kThing(60, 60, 60, 50);

cv::Mat floats(const cv::Mat& image) {
  cv::Mat values;
  image.convertTo(values, CV_32F);
  return values;
}

// The platform with a strongly textured object at `place`.
cv::Mat scene_with(const cv::Rect& place) {
  cv::Mat scene = test::texture(kSize, cv::Scalar(105, 115, 120), 6, 1);
  test::texture(kThing.size(), cv::Scalar(60, 90, 190), 30, 2).copyTo(scene(place));
  return scene;
}

double part_moved(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat changed = cv::Mat::zeros(kSize, CV_8UC1);
  changed(kThing).setTo(255);
  const cv::Mat moved = moved_neighbours(floats(test::exposed(before, 3)),
                                         floats(test::exposed(after, 4)), changed, kSigma);
  EXPECT_EQ(cv::countNonZero(moved & ~changed), 0);
  return cv::countNonZero(moved) / double(kThing.area());
}

class Nudge : public testing::TestWithParam<cv::Point> {};

TEST_P(Nudge, IsRecognised) {
  EXPECT_GT(part_moved(scene_with(kThing), scene_with(kThing + GetParam())), 0.8);
}

INSTANTIATE_TEST_SUITE_P(MovedNeighbour, Nudge,
                         testing::Values(cv::Point(6, 0), cv::Point(-4, 8), cv::Point(5, -3)));

TEST(MovedNeighbour, ADepartureIsNoMovedNeighbour) {
  const cv::Mat platform = test::texture(kSize, cv::Scalar(105, 115, 120), 6, 1);
  EXPECT_LT(part_moved(scene_with(kThing), platform), 0.02);
}

TEST(MovedNeighbour, AnObjectThatMovedFarIsNoMovedNeighbour) {
  EXPECT_LT(part_moved(scene_with(kThing), scene_with(kThing + cv::Point(80, 60))), 0.02);
}

TEST(MovedNeighbour, IsNoPartOfTheObject) {
  test::DrawnLesson drawn = test::draw_lesson();
  const cv::Rect neighbour(150, 96, 70, 30);  // reaches into the region
  const cv::Mat looks = test::texture(neighbour.size(), cv::Scalar(190, 120, 60), 30, 5);
  cv::Mat before = drawn.scene.clone(), after = drawn.platform.clone();
  looks.copyTo(before(neighbour), drawn.truth(neighbour) == 0);
  looks.copyTo(after(neighbour + cv::Point(4, 5)));
  drawn.lesson.before = test::exposed(before, 11);
  drawn.lesson.after = test::exposed(after, 12);
  drawn.lesson.region |= cv::Rect(170, 96, 10, 30);
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_TRUE(result.has_model) << result.message;
  EXPECT_GT(test::iou(test::map_of(result), drawn.truth), 0.9);
}

}  // namespace
}  // namespace mbncc::change
