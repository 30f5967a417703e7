// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

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

// More than one search follows candidates.
TEST_F(ManyObjects, AllOfManyInstancesAreFound) {
  constexpr int kColumns = 9, kInstances = 108;
  SearchConfig config;
  config.max_instances = 2 * kInstances;
  cv::Mat scene(120 * kInstances / kColumns, 120 * kColumns, CV_8UC3, cv::Scalar(90, 100, 95));
  for (int k = 0; k < kInstances; ++k)
    place(scene, LearningImage(2), reference_.position(),
          {60.0 + 120 * (k % kColumns), 60.0 + 120 * (k / kColumns), 0.9 * k});
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  for (int k = 2; k < 8; ++k) {
    objects.push_back(object_from(LearningImage(k), reference_, "object" + std::to_string(k)));
    if (k != 2 && k != 7) continue;
    const SearchResult result = matcher_of(objects, config).find(scene);
    EXPECT_EQ(std::count_if(
                  result.matches.begin(), result.matches.end(),
                  [](const Match& match) { return match.name == "object2" && match.graspable; }),
              kInstances)
        << "of one among " << objects.size();
  }
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
