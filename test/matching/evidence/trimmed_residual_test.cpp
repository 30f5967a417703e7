// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/trimmed_residual.hpp"

#include <gtest/gtest.h>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/surface_sample.hpp"

namespace mbncc::evidence {
namespace {

class TrimmedResidualTest : public ::testing::Test {
 protected:
  const test::LearningImage source_{1};
  const prepared::PreparedObject object_{test::object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};
  const templates::SurfaceTemplate& surface_ = object_.views.front().fine.surface;

  /// Residual if `light` maps the template's colours to those of the image.
  template <class Light>
  double residual(const Light& light) const {
    return trimmed_residual(templates::block_sums(surface_, test::sample_of(surface_, light)));
  }
};

TEST_F(TrimmedResidualTest, GainAndOffsetAreExplainedByLight) {
  EXPECT_LT(residual([](float colour, float, float) { return 0.8f * colour + 20; }), 1);
}

TEST_F(TrimmedResidualTest, AnotherSurfaceHasALargeResidual) {
  EXPECT_GT(residual([](float colour, float, float) { return 255 - colour; }), 20);
}

TEST_F(TrimmedResidualTest, ACoverOfAThirdDoesNotDecide) {
  EXPECT_LT(residual([](float colour, float, float y) { return y < -15 ? 30 : colour; }), 1);
  EXPECT_GT(residual([](float colour, float, float y) { return y < 25 ? 30 : colour; }), 5);
}

TEST_F(TrimmedResidualTest, WithoutPartsThereIsNoResidual) {
  EXPECT_LT(trimmed_residual({}), 0);
  templates::SurfaceSample outside =
      test::sample_of(surface_, [](float, float, float) { return 0.f; });
  std::fill(outside.inside.begin(), outside.inside.end(), 0.f);
  EXPECT_LT(trimmed_residual(templates::block_sums(surface_, outside)), 0);
}

}  // namespace
}  // namespace mbncc::evidence
