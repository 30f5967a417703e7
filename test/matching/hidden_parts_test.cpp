// One light that explains most compact parts of a surface, and parts that a picture does not show.
#include "matching/hidden_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "matching/block_residuals.hpp"
#include "matching/evidence.hpp"
#include "matching/local_cast.hpp"
#include "matching/pictures.hpp"
#include "matching/prepared_object.hpp"

namespace mbncc {
namespace {

class HiddenPartsTest : public ::testing::Test {
 protected:
  const test::LearningPicture source_{1};
  const PreparedObject object_{test::object_from(source_, {58, 60, 0}), Engine::kFast};
  const PoseTemplate& fine_ = object_.views.front().fine;
  const SurfaceTemplate& surface_ = fine_.surface;

  /// The template's own colours in that light.
  SurfaceSample seen(const cv::Vec3f& gains, float offset) const {
    SurfaceSample sample;
    for (int c = 0; c < SurfaceTemplate::kChannels; ++c) {
      sample.planes[c] = surface_.planes[c];
      for (auto& value : sample.planes[c]) value = gains[c] * value + offset;
    }
    sample.inside.assign(surface_.padded(), 0.f);
    std::fill_n(sample.inside.begin(), surface_.size(), 1.f);
    sample.points = surface_.size();
    sample.forget_outside();
    return sample;
  }

  /// Covers the first `count` compact parts.
  void cover(std::size_t count, SurfaceSample& sample) const {
    for (int i = 0; i < surface_.block_ends[count - 1]; ++i)
      for (int c = 0; c < SurfaceTemplate::kChannels; ++c) sample.planes[c][i] = 60.f + 80.f * c;
  }

  std::vector<double> residuals(const SurfaceSample& sample) const {
    return block_residuals(surface_, sample, block_sums(surface_, sample));
  }

  ContourSample found_contour() const {
    ContourSample contour;
    for (auto* values : {&contour.response, &contour.seen, &contour.pull, &contour.moment})
      values->assign(fine_.contour.ones.begin(), fine_.contour.ones.end());
    return contour;
  }
};

TEST_F(HiddenPartsTest, OneLightExplainsWhatIsNotCovered) {
  ASSERT_EQ(surface_.block_ends.size(), 8u);
  auto sample = seen({0.8f, 0.8f, 0.8f}, 20);
  cover(3, sample);
  const auto off = residuals(sample);
  for (std::size_t block = 0; block < off.size(); ++block)
    if (block < 3)
      EXPECT_GT(off[block], 30) << block;
    else
      EXPECT_LT(off[block], 1) << block;
  EXPECT_LT(best_of(off), 1);
}

TEST_F(HiddenPartsTest, PartsOutsideThePictureAreNotJudged) {
  auto sample = seen({1, 1, 1}, 0);
  std::fill_n(sample.inside.begin(), surface_.block_ends[0], 0.f);
  sample.forget_outside();
  EXPECT_EQ(residuals(sample).front(), -1);
  EXPECT_LT(best_of(residuals(sample)), 1);
  EXPECT_LT(best_of({-1, -1}), 0);
}

TEST_F(HiddenPartsTest, CoveredPartsAreTakenOutWithTheContourBesideThem) {
  auto sample = seen({1, 1, 1}, 0);
  cover(2, sample);
  auto contour = found_contour();
  const double before = std::accumulate(contour.seen.begin(), contour.seen.end(), 0.0);
  EXPECT_NEAR(fine_.hidden.take_out(residuals(sample), sample, contour), 0.25, 0.01);
  EXPECT_EQ(sample.visible, surface_.size() - surface_.block_ends[1]);
  const double after = std::accumulate(contour.seen.begin(), contour.seen.end(), 0.0);
  EXPECT_LT(after, 0.95 * before);
  EXPECT_GT(after, 0.5 * before);
}

TEST_F(HiddenPartsTest, WhatIsSeenOrCoveredByHalfStays) {
  for (const std::size_t covered : {0, 4}) {
    auto sample = seen({1, 1, 1}, 0);
    if (covered > 0) cover(covered, sample);
    auto contour = found_contour();
    EXPECT_EQ(fine_.hidden.take_out(residuals(sample), sample, contour), 0);
    EXPECT_EQ(sample.visible, surface_.size());
    EXPECT_EQ(contour.seen, found_contour().seen);
  }
}

TEST_F(HiddenPartsTest, TheCastIsThatOfMostParts) {
  auto sample = seen({0.85f, 1, 1.15f}, 0);
  cover(3, sample);
  auto blocks = block_sums(surface_, sample);
  const auto cast = local_cast(blocks);
  ASSERT_TRUE(cast);
  EXPECT_NEAR(cast->blue, std::log(0.85), 0.01);
  EXPECT_NEAR(cast->red, std::log(1.15), 0.01);
  take_out(*cast, sample);
  take_out(*cast, blocks);
  EXPECT_LT(best_of(block_residuals(surface_, sample, blocks)), 1);
}

TEST_F(HiddenPartsTest, NoCastIsToldInTheDarkNorBeyondBounds) {
  EXPECT_FALSE(local_cast(block_sums(surface_, seen({0.05f, 0.05f, 0.05f}, 0))));
  const ColourCast most = bounded({2, -2});
  EXPECT_NEAR(most.blue, 0.3, 1e-9);
  EXPECT_NEAR(most.red, -0.3, 1e-9);
}

}  // namespace
}  // namespace mbncc
