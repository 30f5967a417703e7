// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/photometric_residual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/surface_sample.hpp"

namespace mbncc::evidence {
namespace {

class LitSurfaceTest : public ::testing::Test {
 protected:
  using Light = std::function<float(float colour, float x, float y)>;

  const test::LearningImage source_{1};
  const prepared::PreparedObject object_{test::object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};
  const prepared::PreparedView& view_ = object_.views.front();
  const templates::SurfaceTemplate& surface_ = view_.fine.surface;

  /// Of the template's own colours in that light.
  double misfit_in(const Light& light) const {
    return view_.lit.misfit(test::sample_of(surface_, light));
  }
};

TEST_F(LitSurfaceTest, GainAndShadingAreLight) {
  EXPECT_LT(misfit_in([](float colour, float, float) { return colour; }), 0.1);
  EXPECT_LT(misfit_in([](float colour, float x, float) { return 0.8f * colour + 0.3f * x; }), 0.5);
}

TEST_F(LitSurfaceTest, WhatGlossHidesCountsLess) {
  constexpr float kGloss = 120;
  double glossy = 0;
  const auto in_gloss = [](float x, float y) { return std::hypot(x, y - 20) < 8; };
  for (std::size_t i = 0; i < surface_.size(); ++i)
    glossy += in_gloss(surface_.x[i], surface_.y[i]) ? 1 : 0;
  ASSERT_GT(glossy, 10);
  const double rms = kGloss * std::sqrt(3 * glossy / static_cast<double>(surface_.size()));
  EXPECT_LT(misfit_in([&](float colour, float x, float y) {
              return in_gloss(x, y) ? colour + kGloss : colour;
            }),
            std::log(rms) - 0.7)
      << "half at most";
}

TEST_F(LitSurfaceTest, AnotherSurfaceIsNotExplainedByLight) {
  EXPECT_GT(misfit_in([](float colour, float, float) { return 255 - colour; }), 2);
}

TEST_F(LitSurfaceTest, NothingIsComparedWhereNothingIsSeen) {
  EXPECT_DOUBLE_EQ(view_.lit.misfit({}), 0);
  EXPECT_DOUBLE_EQ(PhotometricResidual().misfit({}), 0);
}

}  // namespace
}  // namespace mbncc::evidence
