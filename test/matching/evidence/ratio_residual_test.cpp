// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/ratio_residual.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/surface_sample.hpp"

namespace mbncc::evidence {
namespace {

class RatioResidualTest : public ::testing::Test {
 protected:
  using Light = std::function<float(float colour, float x, float y)>;

  const test::LearningImage source_{1};
  const prepared::PreparedObject object_{test::object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};
  const prepared::PreparedView& view_ = object_.views.front();
  const templates::SurfaceTemplate& surface_ = view_.fine.surface;

  /// Misfit of the template's own colours in this light.
  double misfit_in(const Light& light) const {
    return view_.ratios.misfit(surface_, test::sample_of(surface_, light));
  }
};

TEST_F(RatioResidualTest, GainAndShadingAreExplainedByLight) {
  EXPECT_LT(misfit_in([](float colour, float, float) { return colour; }), 0.01);
  EXPECT_LT(misfit_in([](float colour, float, float) { return 0.4f * colour; }), 0.01);
  EXPECT_LT(misfit_in([](float colour, float x, float) { return (0.8f + 0.005f * x) * colour; }),
            1.2);
}

TEST_F(RatioResidualTest, ShadowEdgesAreExplainedByLight) {
  EXPECT_LT(misfit_in([](float colour, float x, float y) {
              return std::fmod(x + y + 140, 14.F) < 7 ? colour : 0.45f * colour;
            }),
            1.2);
}

TEST_F(RatioResidualTest, ACoverOfLessThanHalfDoesNotDecide) {
  std::vector<float> places(surface_.x.begin(), surface_.x.begin() + surface_.size());
  const auto edge = places.begin() + static_cast<std::ptrdiff_t>(0.65 * places.size());
  std::nth_element(places.begin(), edge, places.end());
  const double covered =
      misfit_in([&](float colour, float x, float) { return x < *edge ? colour : 250; });
  EXPECT_LT(covered, misfit_in([](float colour, float, float) { return 255 - colour; }) - 1);
}

TEST_F(RatioResidualTest, AnotherSurfaceIsNotExplainedByLight) {
  EXPECT_GT(misfit_in([](float colour, float, float) { return 255 - colour; }), 2);
}

TEST_F(RatioResidualTest, OnlyPointsThatAreComparedCount) {
  std::vector<float> heights(surface_.y.begin(), surface_.y.begin() + surface_.size());
  const auto third = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 3);
  std::nth_element(heights.begin(), third, heights.end());
  templates::SurfaceSample sample = test::sample_of(
      surface_, [&](float colour, float, float y) { return y < *third ? colour : 255 - colour; });
  for (std::size_t i = 0; i < surface_.size(); ++i)
    if (surface_.y[i] >= *third) sample.inside[i] = 0;
  sample.visible =
      static_cast<std::size_t>(std::count(sample.inside.begin(), sample.inside.end(), 1.F));
  ASSERT_TRUE(sample.suffices());
  EXPECT_LT(view_.ratios.misfit(surface_, sample), 0.01);
}

TEST_F(RatioResidualTest, InvisiblePointsAreNotCompared) {
  EXPECT_DOUBLE_EQ(view_.ratios.misfit(surface_, {}), 0);
  EXPECT_DOUBLE_EQ(RatioResidual().misfit(surface_, {}), 0);
}

}  // namespace
}  // namespace mbncc::evidence
