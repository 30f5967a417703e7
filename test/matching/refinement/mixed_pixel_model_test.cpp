// SPDX-License-Identifier: BSD-3-Clause
// Small objects: the pose is settled by how object and background mix along the edge.
#include "matching/refinement/mixed_pixel_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "matching/pictures.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::refinement {
namespace {

const cv::Size kSize{80, 70};
const cv::Scalar kBlue{170, 90, 50}, kSand{120, 150, 165};

/// Light on the object: a gain, an offset, how much brighter its left is than its right, and how
/// much its relief makes brighter or darker.
struct Light {
  double gain = 1, offset = 0, slope = 0, relief = 0;
};

/// Share of each pixel that a bent strip, 18 px long and 5 px wide, covers at `pose`.
cv::Mat coverage_at(const Pose2D& pose) {
  constexpr int kFine = 8;
  cv::Mat fine(kSize * kFine, CV_32FC1, cv::Scalar(0)), share;
  std::vector<cv::Point> corners;
  for (const cv::Point2d corner :
       {cv::Point2d(-9, -6), {9, -6}, {9, -1}, {-4, -1}, {-4, 6}, {-9, 6}})
    corners.push_back((transform(pose, corner) + cv::Point2d(0.5, 0.5)) * kFine);
  cv::fillPoly(fine, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(1));
  cv::resize(fine, share, kSize, 0, 0, cv::INTER_AREA);
  return share;
}

/// The strip as a camera sees it.
cv::Mat seen(const cv::Mat& background, const Pose2D& pose, const Light& light = {}) {
  const cv::Mat share = coverage_at(pose);
  cv::Mat picture;
  background.convertTo(picture, CV_32F);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const float part = share.at<float>(y, x);
      const double own = light.offset + light.slope * (pose.x - x) / 9 +
                         light.relief * std::sin(1.1 * x + 0.7 * y);
      auto& pixel = picture.at<cv::Vec3f>(y, x);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<float>(part * (light.gain * kBlue[c] + own) + (1 - part) * pixel[c]);
    }
  cv::GaussianBlur(picture, picture, {}, 0.8);
  cv::Mat noise(kSize, CV_32FC3), result;
  cv::RNG random(7);
  random.fill(noise, cv::RNG::NORMAL, 0, 3);
  picture += noise;
  picture.convertTo(result, CV_8U);
  return result;
}

class RenderingTest : public ::testing::Test {
 protected:
  RenderingTest() {
    const cv::Mat share = coverage_at(kLearned);
    map_ = share >= 0.5;
    view_ = std::make_unique<prepared::PreparedView>(
        crop_view(seen(cv::Mat(kSize, CV_8UC3, kSand), kLearned), map_, kLearned),
        prepared::Engine::kFast);
  }

  /// Of the rendering that shows the object at `truth`.
  Pose2D anchor_at(const Pose2D& truth) const {
    return compose(truth, inverse(view_->reference_in_anchor));
  }

  /// Fits from around the truth and expects to arrive there.
  void expect_found(const cv::Mat& picture, const Pose2D& truth) const {
    const scene::SceneLevel scene(picture, 0);
    const Pose2D wanted = anchor_at(truth);
    for (int k = 0; k < 8; ++k) {
      const double direction = k * kPi / 4;
      const Pose2D start{wanted.x + std::cos(direction), wanted.y + std::sin(direction),
                         wanted.theta + to_radians(k % 2 ? 6. : -6.)};
      const Pose2D found = fit(view_->rendering, scene, start).pose;
      EXPECT_LT(cv::norm(found.position() - wanted.position()), 0.25) << "direction " << k;
      EXPECT_LT(to_degrees(angle_distance(found.theta, wanted.theta)), 1.5) << "direction " << k;
    }
  }

  static const Pose2D kLearned;
  cv::Mat map_;
  std::unique_ptr<prepared::PreparedView> view_;
};

const Pose2D RenderingTest::kLearned{38.3, 31.8, 0.3};

TEST_F(RenderingTest, FindsBackBeforeOtherBackgrounds) {
  for (const double turn : {-2.5, -0.4, 0.9, 2.2})
    for (const double grey : {30., 150., 230.}) {
      SCOPED_TRACE(::testing::Message() << "turned by " << turn << " before " << grey);
      const Pose2D truth{41.6, 33.1, turn};
      expect_found(seen(cv::Mat(kSize, CV_8UC3, cv::Scalar::all(grey)), truth), truth);
    }
}

TEST_F(RenderingTest, FindsBackBeforeTexture) {
  const Pose2D truth{40.2, 35.7, -1.1};
  expect_found(seen(test::texture(kSize, 5, 5), truth), truth);
}

TEST_F(RenderingTest, LightDoesNotMoveIt) {
  const cv::Mat background(kSize, CV_8UC3, cv::Scalar::all(190));
  for (const Light& light : {Light{1.3, 0, 0}, Light{0.8, 15, 0}, Light{1, 0, 25}}) {
    SCOPED_TRACE(::testing::Message() << "gain " << light.gain << ", offset " << light.offset
                                      << ", slope " << light.slope);
    const Pose2D truth{39.5, 36.2, 1.7};
    expect_found(seen(background, truth, light), truth);
  }
}

TEST_F(RenderingTest, ExplainsTheObjectInAnyLightAndNothingElse) {
  const cv::Mat ground = test::texture(kSize, 5, 5);
  const Pose2D truth{40.2, 35.7, -1.1};
  for (const Light& light : {Light{}, Light{1.3, 0, 0}, Light{0.8, 15, 0}, Light{1, 0, 25}}) {
    const scene::SceneLevel scene(seen(ground, truth, light), 0);
    const MixedPixelFit here = fit(view_->rendering, scene, anchor_at(truth));
    EXPECT_LT(here.misfit, std::log(9.));
    const MixedPixelFit elsewhere = fit(view_->rendering, scene, anchor_at({18, 18, 2}));
    EXPECT_GT(elsewhere.misfit, here.misfit + 0.3);
  }
}

TEST_F(RenderingTest, TellsBrightness) {
  const cv::Mat ground(kSize, CV_8UC3, cv::Scalar::all(190));
  const Pose2D truth{39.5, 36.2, 1.7};
  for (const double gain : {0.7, 1.0, 1.35}) {
    const scene::SceneLevel scene(seen(ground, truth, {gain, 0, 0}), 0);
    EXPECT_NEAR(fit(view_->rendering, scene, anchor_at(truth)).brightness, std::log(gain), 0.1);
  }
}

TEST_F(RenderingTest, ReliefDoesNotMoveIt) {
  const cv::Mat background(kSize, CV_8UC3, cv::Scalar::all(150));
  for (const double turn : {-2.1, 0.2, 1.7}) {
    SCOPED_TRACE(::testing::Message() << "turned by " << turn);
    const Pose2D truth{39.5, 36.2, turn};
    expect_found(seen(background, truth, {1, 0, 0, 40}), truth);
  }
}

TEST_F(RenderingTest, AxesOfColourKeepLengthsAndGreyIsBrightness) {
  const std::vector<float> colours{120, 10, 70, 120, 200, 60, 120, 30, 90};  // blue, green, red
  std::vector<float> turned = colours;
  MixedPixelModel::turn_to_axes(turned.data(), 3);
  EXPECT_NEAR(cv::norm(turned), cv::norm(colours), 1e-3);
  EXPECT_NEAR(turned[0], std::sqrt(3.) * 120, 1e-3);
  EXPECT_NEAR(turned[3], 0, 1e-3);
  EXPECT_NEAR(turned[6], 0, 1e-3);
}

TEST_F(RenderingTest, StaysWhereNothingIsSeen) {
  const scene::SceneLevel scene(cv::Mat(kSize, CV_8UC3, kSand), 0);
  for (const Pose2D& start : {Pose2D{-60, 30, 1}, Pose2D{79, 69, 0}, Pose2D{1e9, 0, 0}}) {
    const Pose2D found = fit(view_->rendering, scene, start).pose;
    EXPECT_EQ(found.x, start.x);
    EXPECT_EQ(found.theta, start.theta);
  }
}

TEST_F(RenderingTest, LargeObjectsHaveNone) {
  const test::LearningPicture source(3);
  const prepared::PreparedView large(crop_view(source.picture, source.map, {60, 60, 0}),
                                     prepared::Engine::kFast);
  EXPECT_EQ(large.rendering.padded(), 0u);
  const scene::SceneLevel scene(source.picture, 0);
  EXPECT_EQ(fit(large.rendering, scene, {3, 4, 5}).pose.y, 4);
}

}  // namespace
}  // namespace mbncc::refinement
