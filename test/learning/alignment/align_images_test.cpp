// SPDX-License-Identifier: BSD-3-Clause
// Light, camera shift and noise between two images of one scene.
#include "learning/alignment/align_images.hpp"

#include <gtest/gtest.h>

#include "learning/alignment/camera_shift.hpp"
#include "learning/alignment/image_shift.hpp"
#include "learning/alignment/photometric_fit.hpp"
#include "learning/images.hpp"
#include "learning/likelihood/noise_model.hpp"
#include "learning/likelihood/normalized_difference.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(240, 200);
const cv::Scalar kTable(105, 115, 120);

cv::Mat all_of(cv::Size size) {
  return cv::Mat(size, CV_8UC1, cv::Scalar(255));
}

cv::Mat floats(const cv::Mat& image) {
  cv::Mat values;
  image.convertTo(values, CV_32F);
  return values;
}

double mean_error(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total() * 3);
}

TEST(PhotometricFit, RecoversGainOffsetAndPlane) {
  const cv::Mat after = test::texture(kSize, kTable, 20, 1);
  const alignment::ChannelLight made{0.12, 0.06, -0.04, 5};
  const cv::Mat before = alignment::apply_light(after, {made, made, made});
  const alignment::Light found = alignment::fit_light(before, after, all_of(kSize), true);
  EXPECT_LT(mean_error(alignment::apply_light(after, found), before), 0.3);
}

TEST(PhotometricFit, FollowsALargeChangeOfTheExposure) {
  const cv::Mat after = test::texture(kSize, kTable, 20, 1);
  for (const double exposure : {0.4, 1.7}) {
    const cv::Mat before = after * exposure;
    const alignment::Light found = alignment::fit_light(before, after, all_of(kSize), true);
    EXPECT_LT(mean_error(alignment::apply_light(after, found), floats(before)), 1) << exposure;
  }
}

TEST(PhotometricFit, FollowsAnotherWhiteBalance) {
  const cv::Mat after = test::texture(kSize, kTable, 20, 1);
  cv::Mat before;
  cv::multiply(after, cv::Scalar(1.35, 1, 0.75), before);
  const alignment::Light found = alignment::fit_light(before, after, all_of(kSize), true);
  EXPECT_LT(mean_error(alignment::apply_light(after, found), floats(before)), 1);
}

// Undoing a shift gives values below 0 beside bright edges.
TEST(PhotometricFit, BearsValuesBelowZero) {
  cv::Mat after = floats(test::texture(kSize, kTable, 20, 1));
  const cv::Mat before = after * 1.2;
  after(cv::Rect(0, 0, 60, 60)).setTo(cv::Scalar::all(-9));
  const alignment::Light found = alignment::fit_light(before, after, all_of(kSize), true);
  const cv::Rect rest(60, 60, 180, 140);
  EXPECT_LT(mean_error(alignment::apply_light(after, found)(rest), before(rest)), 1);
}

TEST(PhotometricFit, IgnoresAForeignQuarter) {
  const cv::Mat after = test::texture(kSize, kTable, 20, 1);
  cv::Mat before = after * 1.1;
  before(cv::Rect(0, 0, 120, 100)).setTo(cv::Scalar(250, 10, 10));
  const alignment::Light found = alignment::fit_light(before, after, all_of(kSize), false);
  const cv::Rect rest(120, 100, 120, 100);
  EXPECT_LT(mean_error(alignment::apply_light(after, found)(rest), before(rest)), 0.5);
}

// Shadows on the left of the image after and on the right of the one before.
struct MovedShadows {
  cv::Rect left, lit, right;
  cv::Mat before, after;

  MovedShadows(double exposure, int width)
      : left(0, 0, width, kSize.height),
        lit(width, 0, kSize.width - 2 * width, kSize.height),
        right(kSize.width - width, 0, width, kSize.height) {
    const cv::Mat platform = test::texture(kSize, kTable, 20, 1);
    before = platform * exposure;
    after = platform.clone();
    before(right) *= 0.6;
    after(left) *= 0.6;
  }
};

TEST(PhotometricFit, IsThatOfTheUnchangedPlatformBesideMovedShadows) {
  for (const double exposure : {0.9, 1.0, 1.2}) {
    const MovedShadows moved(exposure, 84);
    const alignment::Light found =
        alignment::fit_light(moved.before, moved.after, all_of(kSize), true);
    const cv::Mat lit = alignment::apply_light(moved.after, found);
    EXPECT_LT(mean_error(lit(moved.lit), floats(moved.before(moved.lit))), 1) << exposure;
  }
}

TEST(AlignImages, ShadowsAreNotTrusted) {
  const MovedShadows moved(1, 96);
  const alignment::AlignedPair pair =
      alignment::align_images(test::exposed(moved.before, 5), test::exposed(moved.after, 6),
                              {110, 90, 20, 20}, cv::Mat::zeros(kSize, CV_8UC1), 4);
  ASSERT_EQ(pair.window.height, 100);
  const auto trusted_part = [&](const cv::Rect& area) {
    const cv::Mat part = pair.trusted((area & pair.window) - pair.window.tl());
    return cv::countNonZero(part) / static_cast<double>(part.total());
  };
  EXPECT_LT(trusted_part(moved.left), 0.02);
  EXPECT_LT(trusted_part(moved.right), 0.02);
  EXPECT_GT(trusted_part(moved.lit), 0.5);
}

TEST(PhotometricFit, TooFewPixelsGiveTheIdentity) {
  const cv::Mat after = test::texture(kSize, kTable, 20, 1);
  const alignment::Light found =
      alignment::fit_light(after * 2, after, cv::Mat::zeros(kSize, CV_8UC1), true);
  EXPECT_EQ(mean_error(alignment::apply_light(after, found), after), 0);
}

class Shift : public testing::TestWithParam<cv::Point2d> {};

TEST_P(Shift, IsFoundToAFiftiethOfAPixel) {
  const cv::Mat wide = test::texture({300, 260}, kTable, 20, 3);
  const cv::Rect inner(30, 30, 240, 200);
  // undo_shift(after, s)(x) = after(x + s) = before(x).
  const cv::Mat after = alignment::undo_shift(wide, -GetParam())(inner);
  const cv::Mat b = floats(test::exposed(wide(inner), 5)), a = floats(test::exposed(after, 6));
  const cv::Point2d found = alignment::estimate_shift(
      alignment::smooth_luminance(b), alignment::smooth_luminance(a), all_of(kSize), 8);
  EXPECT_NEAR(found.x, GetParam().x, 0.02);
  EXPECT_NEAR(found.y, GetParam().y, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Camera, Shift,
                         testing::Values(cv::Point2d(0.4, -0.3), cv::Point2d(-1.5, 0.8),
                                         cv::Point2d(2.2, 2.6)));

TEST(CameraShift, IsZeroWhereNothingMoved) {
  const cv::Mat scene = test::texture(kSize, kTable, 20, 3);
  const cv::Mat b = floats(test::exposed(scene, 5)), a = floats(test::exposed(scene, 6));
  EXPECT_EQ(alignment::estimate_shift(alignment::smooth_luminance(b),
                                      alignment::smooth_luminance(a), all_of(kSize), 8),
            cv::Point2d());
}

TEST(CameraShift, IsNotCorrectedIfItExceedsTheLimit) {
  const cv::Mat wide = test::texture({300, 260}, kTable, 20, 3, 8);
  const cv::Mat b = wide(cv::Rect(30, 30, 240, 200)), a = wide(cv::Rect(26, 30, 240, 200));
  EXPECT_EQ(alignment::estimate_shift(alignment::smooth_luminance(b),
                                      alignment::smooth_luminance(a), all_of(kSize), 2),
            cv::Point2d());
}

TEST(AlignImages, TheRingExcludesTheRegionAndMovedNeighbours) {
  const test::DrawnLesson drawn = test::draw_lesson({120, 100}, {320, 240});
  cv::Mat before = drawn.lesson.before.clone();
  const cv::Rect neighbour(200, 110, 20, 20);
  before(neighbour).setTo(cv::Scalar(20, 20, 20));
  const alignment::AlignedPair pair = alignment::align_images(
      before, drawn.lesson.after, drawn.lesson.region, cv::Mat::zeros(before.size(), CV_8UC1), 8);
  const auto trusted_in = [&](const cv::Rect& rect) {
    const cv::Rect inside = (rect - pair.window.tl()) & cv::Rect({0, 0}, pair.window.size());
    return cv::countNonZero(pair.trusted(inside));
  };
  EXPECT_EQ(trusted_in(drawn.lesson.region), 0);
  EXPECT_EQ(trusted_in(neighbour & pair.window), 0);
  EXPECT_GT(cv::countNonZero(pair.trusted), 0.3 * pair.window.area());
}

TEST(NoiseModel, EstimatesTheNoiseOfBothImages) {
  for (const double sigma : {1.5, 4.0}) {
    const cv::Mat scene(kSize, CV_32FC3, kTable);
    alignment::AlignedPair pair;
    pair.before = floats(test::exposed(scene, 1, 1, sigma));
    pair.after = floats(test::exposed(scene, 2, 1, sigma));
    pair.trusted = all_of(kSize);
    const likelihood::NoiseModel noise = likelihood::learn_noise(pair);
    const double both = std::sqrt(2.0) * sigma;
    EXPECT_NEAR(noise.variance[1][115 / 16], both * both, 0.25 * both * both);
    EXPECT_LT(noise.tail, 1.6);
  }
}

TEST(NoiseModel, HasALargerVarianceAtEdges) {
  alignment::AlignedPair pair;
  pair.after = test::texture(kSize, kTable, 40, 3, 1.5);
  pair.before = alignment::undo_shift(pair.after, {0.25, 0.1});
  pair.trusted = all_of(kSize);
  const cv::Mat variance = likelihood::learn_noise(pair).variance_image(pair.after);
  double low = 0, high = 0;
  cv::minMaxLoc(variance.reshape(1), &low, &high);
  EXPECT_GT(high, 3 * low);
}

// The noise affects only brightness, as after compression: a change of colour is then more
// significant than an equal change of brightness.
TEST(NoiseModel, EstimatesTheCorrelationOfTheChannels) {
  cv::Mat common(kSize, CV_32FC1), own(kSize, CV_32FC3);
  cv::RNG random(7);
  random.fill(common, cv::RNG::NORMAL, 0, 4);
  random.fill(own, cv::RNG::NORMAL, 0, 0.7);
  cv::Mat grey;
  cv::merge(std::vector<cv::Mat>(3, common), grey);
  alignment::AlignedPair pair;
  pair.after = cv::Mat(kSize, CV_32FC3, kTable);
  pair.before = pair.after + grey + own;
  pair.trusted = all_of(kSize);
  const likelihood::NoiseModel noise = likelihood::learn_noise(pair);
  EXPECT_GT(noise.correlation(0, 1), 0.7);
  const cv::Mat variance = noise.variance_image(pair.after);
  const auto distance = [&](const cv::Scalar& change) {
    const cv::Mat changed = pair.after + change;
    return cv::mean(
        likelihood::normalized_difference(changed, pair.after, variance, noise.correlation))[0];
  };
  EXPECT_GT(distance({10, 0, -10}), 3 * distance({8, 8, 8}));
  EXPECT_NEAR(distance({8, 8, 8}), distance({-8, -8, -8}), 1e-3 * distance({8, 8, 8}));
}

TEST(NoiseModel, KeepsIndependentChannelsUncorrelated) {
  const cv::Mat scene(kSize, CV_32FC3, kTable);
  alignment::AlignedPair pair;
  pair.before = floats(test::exposed(scene, 1, 1, 3));
  pair.after = floats(test::exposed(scene, 2, 1, 3));
  pair.trusted = all_of(kSize);
  const likelihood::NoiseModel noise = likelihood::learn_noise(pair);
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
    EXPECT_NEAR(noise.correlation(i, j), 0, 0.1);
}

}  // namespace
}  // namespace mbncc
