// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/local_cast.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "matching/evidence/evidence.hpp"
#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/search/colour_cast.hpp"
#include "matching/surface_sample.hpp"

namespace mbncc::evidence {
namespace {

class LocalCastTest : public test::MatcherTest {
 protected:
  const prepared::PreparedObject object_{test::object_from(source_, reference_),
                                         prepared::Engine::kFast};
  const prepared::PreparedView& view_ = object_.views.front();

  /// Evidence in the learning image itself, in light of another colour.
  Evidence evidence_in(const ColourCast& light) const {
    const cv::Mat image = search::without_cast(source_.image, {-light.blue, -light.red});
    const Pose2D anchor{view_.anchor.x + object_.model->views.front().origin.x,
                        view_.anchor.y + object_.model->views.front().origin.y, 0};
    return gather_evidence(view_.fine, scene::SceneLevel(image, 0), anchor);
  }
};

// The kernels use colours as indices into tables, so they must stay in range.
TEST_F(LocalCastTest, CorrectedColoursStayInRange) {
  templates::SurfaceSample sample =
      test::sample_of(view_.fine.surface, [](float, float, float) { return 250.f; });
  remove_cast(ColourCast{-0.3, -0.3}, sample);
  for (const auto& plane : sample.planes)
    EXPECT_LE(*std::max_element(plane.begin(), plane.end()), 255);
}

TEST_F(LocalCastTest, ACorrectedCastLowersTheOdds) {
  const Evidence plain = evidence_in({}), redder = evidence_in({-0.15, 0.15});
  const double area = view_.shape.area();
  EXPECT_EQ(plain.cast, 0) << "as seen where nothing else is likelier";
  EXPECT_NEAR(redder.cast, 0.21, 0.03);
  EXPECT_NEAR(redder.trimmed_residual, plain.trimmed_residual, 0.4);
  EXPECT_LT(log_odds(redder, area), log_odds(plain, area) - 3);
}

}  // namespace
}  // namespace mbncc::evidence
