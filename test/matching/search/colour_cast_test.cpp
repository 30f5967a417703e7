// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/colour_cast.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::search {
namespace {

class ColourCastTest : public ::testing::Test {
 protected:
  static constexpr int kObjects = 3;
  std::vector<test::LearningImage> sources_;
  std::vector<prepared::PreparedObject> objects_;
  cv::Mat image_ = test::texture({480, 240}, 50, 4);

  ColourCastTest() {
    for (int k = 0; k < kObjects; ++k) {
      sources_.emplace_back(static_cast<std::uint64_t>(k));
      objects_.emplace_back(test::object_from(sources_.back(), {58, 60, 0}),
                            prepared::Engine::kFast);
      test::place(image_, sources_.back(), anchor(k), pose(k));
    }
  }

  cv::Point2d anchor(int k) const {
    return objects_[static_cast<std::size_t>(k)].views.front().anchor +
           cv::Point2d(objects_[static_cast<std::size_t>(k)].model->views.front().origin);
  }
  static Pose2D pose(int k) { return {90.0 + 150 * k, 120, 0.7 * k}; }

  std::vector<std::vector<decision::Detection>> found(int count, double log_odds) const {
    std::vector<std::vector<decision::Detection>> all;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      decision::Detection detection;
      detection.object = objects_[k].model.get();
      detection.view = &objects_[k].views.front();
      detection.pose = pose(static_cast<int>(k));
      detection.odds.best_at_place = log_odds;
      all.push_back({detection});
    }
    return all;
  }

  /// The estimate from the first `count` objects in `image`.
  std::optional<evidence::ColourCast> told(const cv::Mat& image, int count = kObjects,
                                           double log_odds = 6) const {
    const auto scene = std::make_shared<const scene::SceneImage>(image, 0);
    std::vector<prepared::Comparison> compared;
    for (int k = 0; k < count; ++k)
      compared.push_back({&objects_[static_cast<std::size_t>(k)], scene});
    return colour_cast(compared, found(count, log_odds));
  }

  static cv::Mat cast(const cv::Mat& image, double blue, double red) {
    return without_cast(image, {-std::log(blue), -std::log(red)});
  }
};

TEST_F(ColourCastTest, MeasuresTheGainsOfBlueAndRed) {
  const auto gains = told(cast(image_, 0.9, 1.1));
  ASSERT_TRUE(gains);
  EXPECT_NEAR(std::exp(gains->blue), 0.9, 0.015);
  EXPECT_NEAR(std::exp(gains->red), 1.1, 0.015);
}

TEST_F(ColourCastTest, ReportsNoCastInUnchangedLight) {
  EXPECT_FALSE(told(image_));
  const cv::Mat darker = 0.8 * image_;
  EXPECT_FALSE(told(darker)) << "brightness is no colour";
}

TEST_F(ColourCastTest, IgnoresSingleAndUnlikelyObjects) {
  const cv::Mat reddish = cast(image_, 0.9, 1.1);
  EXPECT_FALSE(told(reddish, 1));
  EXPECT_FALSE(told(reddish, kObjects, 0));
  EXPECT_FALSE(told(reddish, 0));
}

TEST_F(ColourCastTest, ReportsNoCastIfObjectsDisagree) {
  cv::Mat mixed = image_.clone();
  cast(image_, 0.8, 1.2)(cv::Rect(0, 0, 165, 240)).copyTo(mixed(cv::Rect(0, 0, 165, 240)));
  cast(image_, 1.2, 0.8)(cv::Rect(165, 0, 150, 240)).copyTo(mixed(cv::Rect(165, 0, 150, 240)));
  EXPECT_FALSE(told(mixed));
}

TEST_F(ColourCastTest, RemovingTheCastRestoresTheImage) {
  const cv::Mat back = without_cast(cast(image_, 0.9, 1.1), {std::log(0.9), std::log(1.1)});
  EXPECT_LT(cv::norm(back, image_, cv::NORM_INF), 45) << "but where red was clipped";
  EXPECT_LT(cv::norm(back, image_, cv::NORM_L1) / static_cast<double>(3 * image_.total()), 1);
}

}  // namespace
}  // namespace mbncc::search
