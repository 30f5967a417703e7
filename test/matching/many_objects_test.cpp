// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "matching/matcher_fixture.hpp"

namespace mbncc {
namespace {

using test::LearningImage;
using test::object_from;
using test::place;
using test::texture;

using ManyObjects = test::MatcherTest;

TEST_F(ManyObjects, ThreadsDoNotChangeTheResult) {
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  for (int k = 0; k < 5; ++k)
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
  cv::Mat scene = texture({320, 240}, 67, 4);
  place(scene, LearningImage(3), reference_.position(), {120, 100, 2});
  SearchConfig config;
  const SearchResult alone = matcher_of(objects, config).find(scene);
  config.threads = 3;
  const SearchResult together = matcher_of(objects, config).find(scene);
  ASSERT_EQ(alone.matches.size(), together.matches.size());
  for (std::size_t i = 0; i < alone.matches.size(); ++i) {
    EXPECT_EQ(alone.matches[i].name, together.matches[i].name);
    EXPECT_EQ(alone.matches[i].pose.x, together.matches[i].pose.x);
    EXPECT_EQ(alone.matches[i].score, together.matches[i].score);
  }
}

TEST_F(ManyObjects, AnObjectAmongManyIsFoundWhereItIsFoundAlone) {
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  for (int k = 0; k < 6; ++k)
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
  for (int k = 0; k < 6; ++k) {
    const Pose2D truth{120, 100, 0.9 * k};
    cv::Mat scene = texture({320, 240}, 71 + static_cast<unsigned>(k), 4);
    place(scene, LearningImage(k), reference_.position(), truth);
    const SearchResult all = matcher_of(objects).find(scene);
    const SearchResult alone = matcher_of({objects[static_cast<std::size_t>(k)]}).find(scene);
    ASSERT_EQ(alone.matches.size(), 1u);
    ASSERT_EQ(all.matches.size(), 1u);
    EXPECT_EQ(all.matches[0].name, alone.matches[0].name);
    expect_at(all.matches[0], truth);
    expect_at(alone.matches[0], truth);
  }
}

TEST_F(ManyObjects, ManyObjectsAreFoundInLightOfAnotherColour) {
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  for (int k = 0; k < 6; ++k)
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
  cv::Mat scene = texture({480, 240}, 72, 4);
  for (int k = 0; k < 3; ++k)
    place(scene, LearningImage(k), reference_.position(), {90.0 + 150 * k, 120, 1.1 * k});
  cv::multiply(scene, cv::Scalar(0.85, 1, 1.15), scene);
  EXPECT_EQ(matcher_of(objects).find(scene).matches.size(), 3u);
}

TEST_F(ManyObjects, LookAlikesAreAmbiguousAmongMany) {
  std::vector<std::shared_ptr<const ObjectModel>> objects{
      object_from(source_, reference_, "twin"), object_from(source_, reference_, "other")};
  for (int k = 2; k < 6; ++k)
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
  cv::Mat scene = texture({320, 240}, 73, 4);
  place(scene, source_, reference_.position(), {160, 120, 0.9});
  const SearchResult result = matcher_of(objects).find(scene);
  ASSERT_EQ(result.matches.size(), 1u) << "one thing is not two";
  EXPECT_TRUE(result.matches[0].ambiguous);
  EXPECT_FALSE(result.matches[0].graspable);
}

constexpr int kCell = 120;  // [px]

constexpr int kColumns = 12;  // of a tray

/// Pose of the k-th instance in tray().
Pose2D instance_of_tray(int k) {
  return {kCell * (k % kColumns + 0.5), kCell * (k / kColumns + 0.5), 0.9 * k};
}

/// `count` instances on a plain table.
cv::Mat tray(const LearningImage& source, const Pose2D& reference, int count) {
  cv::Mat scene(kCell * count / kColumns, kCell * kColumns, CV_8UC3, cv::Scalar(100, 105, 95));
  for (int k = 0; k < count; ++k) place(scene, source, reference.position(), instance_of_tray(k));
  return scene;
}

int count_found(const Matcher& matcher, const cv::Mat& scene, const std::string& name) {
  SearchRequest request;
  request.max_instances = 1000;
  const auto matches = matcher.find(scene, request).matches;
  return static_cast<int>(std::count_if(matches.begin(), matches.end(), [&](const Match& match) {
    return match.name == name && match.score > 0.5;
  }));
}

TEST_F(ManyObjects, ManyInstancesOfOneAmongManyAreFound) {
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  for (int k = 0; k < 6; ++k)
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
  const cv::Mat scene = tray(LearningImage(2), reference_, 48);
  EXPECT_EQ(count_found(matcher_of(objects), scene, "object2"), 48);
}

TEST_F(ManyObjects, EachOfManyInstancesIsAsAccurateAsItsDeviationsSay) {
  cv::Mat scene = tray(source_, reference_, 36);
  cv::Mat noise(scene.size(), CV_16SC3);
  cv::theRNG().state = 3;
  cv::randn(noise, cv::Scalar::all(0), cv::Scalar::all(3));
  cv::add(scene, noise, scene, cv::noArray(), CV_8UC3);
  SearchRequest request;
  request.max_instances = 36;
  const auto matches = matcher_of({object_from(source_, reference_)}).find(scene, request).matches;
  ASSERT_EQ(matches.size(), 36u);
  for (const Match& match : matches) {
    const int column = static_cast<int>(match.pose.x) / kCell;
    const int row = static_cast<int>(match.pose.y) / kCell;
    const Pose2D truth = instance_of_tray(kColumns * row + column);
    EXPECT_LT(std::abs(match.pose.x - truth.x), 4 * std::sqrt(match.covariance(0, 0)));
    EXPECT_LT(std::abs(match.pose.y - truth.y), 4 * std::sqrt(match.covariance(1, 1)));
    EXPECT_LT(std::abs(wrap_angle(match.pose.theta - truth.theta)),
              4 * std::sqrt(match.covariance(2, 2)));
  }
}

TEST_F(ManyObjects, ManyInstancesOfASmallObjectAreFound) {
  LearningImage spoon(2, cv::Mat::zeros(kCell, kCell, CV_8UC1));
  cv::rectangle(spoon.map, cv::Rect(40, 55, 40, 8), cv::Scalar(255), cv::FILLED);
  cv::circle(spoon.map, {42, 59}, 9, cv::Scalar(255), cv::FILLED);
  spoon.surface.setTo(cv::Scalar(60, 80, 150));
  spoon.surface.copyTo(spoon.image, spoon.map);
  const Matcher matcher = matcher_of({object_from(spoon, reference_, "spoon")});
  EXPECT_GT(count_found(matcher, tray(spoon, reference_, 48), "spoon"), 45);
  EXPECT_GT(count_found(matcher, tray(spoon, reference_, 120), "spoon"), 110)
      << "one further search does not find them all";
}

TEST_F(ManyObjects, AShortTimeBudgetSkipsObjectsByName) {
  SearchConfig config;
  config.time_budget = 1e-9;
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  for (int k = 0; k < 6; ++k)
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
  const SearchResult result = matcher_of(objects, config).find(texture({320, 240}, 74, 4));
  EXPECT_TRUE(result.budget_exceeded);
  EXPECT_EQ(result.searched, std::vector<std::string>{"object0"});
  EXPECT_EQ(result.skipped.size(), 5u);
}

}  // namespace
}  // namespace mbncc
