// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_preview.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

mbncc_vision::DetectedObjectArray found(const std::vector<float>& scores) {
  mbncc_vision::DetectedObjectArray array;
  for (const float score : scores) array.objects.emplace_back().score = score;
  return array;
}

TEST(ThresholdPreview, CountsWhatOtherThresholdsWouldReport) {
  const ThresholdPreview preview(found({0.9f, 0.6f, 0.3f}), {0.5, 0.7});
  EXPECT_EQ(preview.summary({0.2, 0.55}),
            "In this picture: reported 3 (now 2), graspable 2 (now 1).");
  EXPECT_EQ(preview.marks({0.95, 0.95}).size(), 0u);
  const auto marks = preview.marks({0.5, 0.7});
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].level, Level::kGood);
  EXPECT_NE(marks[1].level, Level::kGood);
}

TEST(ThresholdPreview, NoThresholdMakesADoubtfulOneGraspable) {
  auto array = found({0.6f, 0.6f});
  array.objects[0].reasons = {"score 0.60 is below confirm_score"};
  array.objects[1].reasons = {"angle open (margin 1.0)"};
  const ThresholdPreview preview(array, {0.5, 0.7});
  EXPECT_EQ(preview.summary({0.5, 0.5}),
            "In this picture: reported 2 (now 2), graspable 1 (now 0).");
}

}  // namespace
}  // namespace mbncc::console
