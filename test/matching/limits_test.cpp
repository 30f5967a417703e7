// SPDX-License-Identifier: BSD-3-Clause
// Limits of a search: time, thresholds set at run time, and very narrow objects.
#include <gtest/gtest.h>

#include "matching/images.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

using test::LearningImage;
using test::object_from;
using test::place;
using test::texture;

const Pose2D kReference{58, 60, 0};

class Limits : public ::testing::Test {
 protected:
  Limits() {
    for (int i = 0; i < 3; ++i) {
      sources_.emplace_back(static_cast<std::uint64_t>(i + 1));
      models_.push_back(object_from(sources_.back(), kReference, "object" + std::to_string(i)));
    }
    scene_ = texture({320, 240}, 50, 4);
    place(scene_, sources_[0], kReference.position(), {100.3, 110.4, 0.7});
    place(scene_, sources_[0], kReference.position(), {230.3, 130.4, -1.7});
  }

  std::vector<LearningImage> sources_;
  std::vector<std::shared_ptr<const ObjectModel>> models_;
  cv::Mat scene_;
};

TEST_F(Limits, ObjectsBeyondTheTimeBudgetAreReportedAsSkipped) {
  SearchConfig config;
  config.time_budget = 1e-9;
  Matcher matcher(config);
  matcher.set_objects(models_);
  const SearchResult result = matcher.find(scene_);
  EXPECT_TRUE(result.budget_exceeded);
  ASSERT_EQ(result.searched.size(), 1u) << "one is always searched";
  EXPECT_EQ(result.skipped.size(), 2u);
  for (const auto& skipped : result.skipped) EXPECT_NE(skipped.find("time"), std::string::npos);
  ASSERT_EQ(result.matches.size(), 2u);
  for (const auto& match : result.matches) {
    EXPECT_FALSE(match.graspable) << "the others may be there as well";
    EXPECT_EQ(match.reasons, std::vector<std::string>{"not compared with object1: time budget"});
  }
}

TEST_F(Limits, ThresholdsChangeAtOnce) {
  Matcher matcher;
  matcher.set_objects(models_);
  EXPECT_EQ(matcher.objects(), models_);
  ASSERT_EQ(matcher.find(scene_).matches.size(), 2u);
  SearchConfig config;
  config.max_instances = 1;
  matcher.configure(config);
  EXPECT_EQ(matcher.find(scene_).matches.size(), 1u);
  config.min_score = 1;
  config.scale_range = 0.1;
  matcher.configure(config);
  EXPECT_TRUE(matcher.find(scene_).matches.empty());
  EXPECT_EQ(matcher.config().scale_range, SearchConfig().scale_range)
      << "they were prepared for it";
}

TEST(LowImages, AreReportedAsNotSearchedForALargeObject) {
  cv::Mat map = cv::Mat::zeros(420, 420, CV_8UC1);
  map(cv::Rect(20, 20, 380, 380)) = 255;
  const LearningImage large(7, map);
  const cv::Mat scene = texture({480, 240}, 50, 4);
  for (const std::string engine : {"fast", "polar"}) {
    SearchConfig config;
    config.engine = engine;
    Matcher matcher(config);
    matcher.set_objects({object_from(large, {210, 210, 0})});
    for (const int height : {16, 240}) {
      const cv::Mat strip = scene.rowRange(0, height);
      for (const cv::Mat& image : {strip, cv::Mat(strip.t())}) {
        const SearchResult result = matcher.find(image);
        EXPECT_EQ(result.searched.size(), height == 16 ? 0u : 1u) << engine;
        ASSERT_EQ(result.skipped.size(), height == 16 ? 1u : 0u) << engine;
        for (const auto& reason : result.skipped)
          EXPECT_NE(reason.find("px wide or high"), std::string::npos);
      }
    }
  }
}

// A bent strip of five pixels, of which hardly anything is left at the coarse levels.
TEST_F(Limits, NarrowObjectsAreFoundUnderNoiseAndInAnotherLight) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(35, 25, 5, 70)) = 255;
  map(cv::Rect(35, 90, 52, 5)) = 255;
  const LearningImage strip(7, map);
  const Pose2D reference{50, 75, 0};
  Matcher matcher;
  matcher.set_objects({object_from(strip, reference)});
  cv::RNG random(9);
  for (int k = 0; k < 6; ++k) {
    const Pose2D truth{120.3 + 10 * k, 120.7, wrap_angle(0.2 + k * kPi / 3)};
    cv::Mat scene = texture({320, 240}, 80 + k, 4), noise(scene.size(), CV_16SC3), noisy;
    place(scene, strip, reference.position(), truth);
    random.fill(noise, cv::RNG::NORMAL, 0, 8);
    scene.convertTo(noisy, CV_16SC3, 0.75);
    cv::Mat(noisy + noise).convertTo(scene, CV_8UC3);
    const SearchResult result = matcher.find(scene);
    ASSERT_FALSE(result.matches.empty()) << k;
    EXPECT_LT(cv::norm(result.matches[0].pose.position() - truth.position()), 1) << k;
    EXPECT_LT(angle_distance(result.matches[0].pose.theta, truth.theta), to_radians(1)) << k;
  }
}

}  // namespace
}  // namespace mbncc
