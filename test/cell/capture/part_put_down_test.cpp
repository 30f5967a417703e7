// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/part_put_down.hpp"

#include <gtest/gtest.h>

#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

class PartPutDownTest : public testing::Test {
 protected:
  sim::Placed at(double x, double y, double theta) const { return {{17, 80, 1.6}, {x, y, theta}}; }

  /// The part lies at its place in the image before, and at the given places, if any, in the image
  /// after.
  double put_down(const std::vector<sim::Placed>& after) const {
    cv::Mat map = scene_.true_map(shown_);
    for (const auto& placed : after) map |= scene_.true_map(placed);
    return part_put_down(map, before_, scene_.render(after, 2));
  }

  const sim::Scene scene_;
  const sim::Placed shown_ = at(320, 240, 0.3);
  const cv::Mat before_ = scene_.render({shown_}, 1);
};

TEST_F(PartPutDownTest, ARemovedObjectCountsAsNotPutDown) {
  EXPECT_LT(part_put_down(scene_.true_map(shown_), before_, scene_.render({}, 2)), 0.15);
  EXPECT_LT(part_put_down(scene_.true_map(shown_), before_, scene_.render({at(500, 300, 1)}, 2)),
            0.15);
}

TEST_F(PartPutDownTest, AMapThatCoversBothPlacesIsDetected) {
  for (const double way : {25.0, 40.0, 60.0, 75.0})
    EXPECT_GT(put_down({at(320 + way, 240, 0.3 + way / 30)}), kMostPutDown + 0.1) << way;
}

TEST_F(PartPutDownTest, DriftingLightMakesNoDifference) {
  const cv::Mat darker = scene_.render({}, 2) * 0.94;
  EXPECT_LT(part_put_down(scene_.true_map(shown_), before_, darker), 0.15);
}

TEST_F(PartPutDownTest, RefusesUnusableImages) {
  EXPECT_THROW(part_put_down(scene_.true_map(shown_), before_, cv::Mat()), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
