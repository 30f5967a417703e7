// SPDX-License-Identifier: BSD-3-Clause
// Compares the fast searches with the exhaustive one.
#include "matching/exhaustive_search.hpp"

#include <gtest/gtest.h>

#include <ostream>

#include "imaging/pyramid.hpp"
#include "matching/images.hpp"
#include "mbncc/matching/polar_search.hpp"

namespace mbncc {
namespace {

/// An L of 26 x 20 px, small enough for a search at all pixels.
cv::Mat small_map() {
  cv::Mat map = cv::Mat::zeros(60, 60, CV_8UC1);
  map(cv::Rect(17, 18, 9, 22)) = 255;
  map(cv::Rect(17, 31, 26, 9)) = 255;
  return map;
}

struct Case {
  std::uint64_t seed;
  Pose2D truth;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << "seed " << one.seed;
}

class AgainstExhaustive : public ::testing::TestWithParam<Case> {
 protected:
  const test::LearningImage source_{GetParam().seed, small_map()};
  const Pose2D reference_{27, 31, 0.3};
  const std::shared_ptr<ObjectModel> object_ = test::object_from(source_, reference_);
  const Pose2D truth_ = GetParam().truth;
  const cv::Mat scene_ = [this] {
    cv::Mat scene = test::texture({72, 60}, GetParam().seed + 500, 3);
    test::place(scene, source_, reference_.position(), truth_);
    return scene;
  }();

  void expect_same(const Pose2D& found, const Match& oracle) const {
    EXPECT_NEAR(found.x, oracle.pose.x, 1);
    EXPECT_NEAR(found.y, oracle.pose.y, 1);
    EXPECT_LT(angle_distance(found.theta, oracle.pose.theta), to_radians(6));
  }

  Match oracle() const {
    ExhaustiveSettings settings;
    settings.angle_step = to_radians(8);
    const auto matches = find_exhaustively(*object_, scene_, settings);
    EXPECT_FALSE(matches.empty());
    return matches.empty() ? Match{} : matches.front();
  }
};

TEST_P(AgainstExhaustive, FastFindsTheSamePose) {
  const Match best = oracle();
  Matcher matcher;
  matcher.set_objects({object_});
  SearchRequest request;
  request.min_score = 0;
  const SearchResult result = matcher.find(scene_, request);
  ASSERT_FALSE(result.matches.empty());
  expect_same(result.matches.front().pose, best);
  expect_same({truth_.x, truth_.y, truth_.theta + reference_.theta}, best);
}

TEST_P(AgainstExhaustive, PolarFindsTheSamePose) {
  const Match best = oracle();
  SearchConfig config;
  config.engine = "polar";
  Matcher matcher(config);
  matcher.set_objects({object_});
  SearchRequest request;
  request.min_score = 0;
  const SearchResult result = matcher.find(scene_, request);
  ASSERT_FALSE(result.matches.empty());
  expect_same(result.matches.front().pose, best);
  const auto& reasons = result.matches.front().reasons;
  EXPECT_NE(std::find(reasons.begin(), reasons.end(), "engine polar compares no other angles"),
            reasons.end());
}

INSTANTIATE_TEST_SUITE_P(Scenes, AgainstExhaustive,
                         ::testing::Values(Case{21, {30.2, 30.6, 0.5}},
                                           Case{22, {45.7, 28.1, -2.2}}, Case{23, {44, 36, 3.1}},
                                           Case{24, {33.3, 25.5, 1.6}}));

TEST(ExhaustiveSearch, FindsNothingInFlatImages) {
  const test::LearningImage source(31, small_map());
  const auto object = test::object_from(source, {27, 31, 0});
  ExhaustiveSettings settings;
  settings.angle_step = to_radians(30);
  EXPECT_TRUE(
      find_exhaustively(*object, cv::Mat(40, 40, CV_8UC3, cv::Scalar(9, 9, 9)), settings).empty());
}

TEST(PolarSearch, EveryRegionFindsTheLessonAgain) {
  const test::LearningImage source(32);
  const auto object = test::object_from(source, {58, 60, 0});
  const View& view = object->views.front();
  cv::Mat grey;
  cv::cvtColor(source.image, grey, cv::COLOR_BGR2GRAY);
  for (const PolarRegion region :
       {PolarRegion::kMap, PolarRegion::kIncircle, PolarRegion::kExcircle}) {
    const PolarSearch search(view, region);
    const cv::Point2d learned = search.centre() + cv::Point2d(view.origin);
    const cv::Rect near(cv::Point(learned) - cv::Point(12, 12), cv::Size(24, 24));
    const auto found = search.find(imaging::build_pyramid(grey, search.top_level()), near);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(cv::norm(found.front().pose.position() - learned), 0.6);
    EXPECT_LT(angle_distance(found.front().pose.theta, 0), to_radians(1));
    EXPECT_GT(found.front().similarity, 0.9);
    EXPECT_TRUE(
        search.find(imaging::build_pyramid(grey, search.top_level()), {5000, 0, 9, 9}).empty())
        << "the region lies outside the image";
  }
}

}  // namespace
}  // namespace mbncc
