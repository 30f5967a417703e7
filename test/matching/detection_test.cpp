#include "matching/detection.hpp"

#include <gtest/gtest.h>

#include "matching/chroma_histogram.hpp"
#include "matching/pictures.hpp"

namespace mbncc {
namespace {

class RotationTest : public ::testing::Test {
 protected:
  const test::LearningPicture source_{1};
  const PreparedObject object_{test::object_from(source_, {58, 60, 0}), Engine::kFast};

  Detection at(double x, double theta, double log_odds, double rotation_odds) const {
    Detection detection;
    detection.object = &object_;
    detection.view = &object_.views.front();
    detection.pose = {x, 100, theta};
    detection.log_odds = log_odds;
    detection.rotation_odds = rotation_odds;
    return detection;
  }
};

TEST_F(RotationTest, WhatLightLeavesAloneDecidesAtOnePlace) {
  const auto compared = compare_rotations({at(100, 0, 6, 40), at(101, 3, 5, 43)});
  ASSERT_EQ(compared.size(), 2u);
  EXPECT_DOUBLE_EQ(compared[0].pose.theta, 3);
  EXPECT_DOUBLE_EQ(compared[0].log_odds, 6) << "the place is as likely as before";
  EXPECT_DOUBLE_EQ(compared[1].log_odds, 3) << "the margin is that of the rotations";
}

TEST_F(RotationTest, OtherPlacesAndHopelessPosesStayAsTheyAre) {
  const auto compared =
      compare_rotations({at(100, 0, 6, 40), at(100, 2, -9, 50), at(400, 1, 2, 60)});
  ASSERT_EQ(compared.size(), 3u);
  EXPECT_DOUBLE_EQ(compared[0].log_odds, 6);
  EXPECT_DOUBLE_EQ(compared[1].log_odds, 2);
  EXPECT_DOUBLE_EQ(compared[2].log_odds, -9);
}

TEST(ChromaCorrelation, KnowsColoursAndNotBrightness) {
  std::array<std::vector<float>, 3> colours, brighter, swapped;
  for (int i = 0; i < 40; ++i) {
    const float red = i % 2 == 0 ? 150.f : 60.f;
    const float values[3] = {100, 80, red}, exchanged[3] = {100, 80, 210 - red};
    for (std::size_t c = 0; c < 3; ++c) {
      colours[c].push_back(values[c]);
      brighter[c].push_back(1.3f * values[c]);
      swapped[c].push_back(exchanged[c]);
    }
  }
  const std::vector<float> inside(40, 1.f);
  EXPECT_GT(chroma_correlation(colours, brighter, inside), 0.9);
  EXPECT_LT(chroma_correlation(colours, swapped, inside), -0.9);
  for (auto& plane : swapped) plane.assign(40, 90.f);
  EXPECT_NEAR(chroma_correlation(colours, swapped, inside), 0, 1e-3) << "grey has no chroma";
}

}  // namespace
}  // namespace mbncc
