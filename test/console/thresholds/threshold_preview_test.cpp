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

TEST(ThresholdPreview, CountsDetectionsAtOtherThresholds) {
  const ThresholdPreview preview(found({0.9f, 0.6f, 0.3f}), {0.5, 0.7});
  EXPECT_EQ(preview.summary({0.2, 0.55}),
            "In this image: reported 3 (now 2), graspable 2 (now 1).");
  EXPECT_EQ(preview.marks({0.95, 0.95}).size(), 0u);
  const auto marks = preview.marks({0.5, 0.7});
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].level, Level::kGood);
  EXPECT_NE(marks[1].level, Level::kGood);
}

TEST(ThresholdPreview, AnObjectsOwnThresholdAppliesToThatObjectOnly) {
  auto array = found({0.6f, 0.6f});
  array.objects[0].name = "part";
  array.objects[1].name = "other";
  Thresholds now{0.5, 0.7};
  now.own["part"] = 0.8;
  const ThresholdPreview preview(array, now);
  EXPECT_EQ(preview.summary(now, "part"),
            "'part' in this image: reported 0 (now 0), graspable 0 (now 0).");
  Thresholds wanted = now;
  wanted.own["part"] = 0.4;
  EXPECT_EQ(preview.summary(wanted, "part"),
            "'part' in this image: reported 1 (now 0), graspable 0 (now 0).");
  EXPECT_EQ(preview.summary(wanted), "In this image: reported 2 (now 1), graspable 0 (now 0).");
  wanted.own.clear();
  wanted.min_score = 0.7;
  EXPECT_EQ(preview.summary(wanted), "In this image: reported 0 (now 1), graspable 0 (now 0).");
}

TEST(ThresholdPreview, OtherImagesAreIgnored) {
  auto array = found({0.9f, 0.9f});
  array.objects[0].reasons = {"graspable in 1 of the last 5 images, 3 needed"};
  array.objects[1].reasons = {"older than valid_until when it was published"};
  const ThresholdPreview preview(array, {0.5, 0.7});
  EXPECT_EQ(preview.summary({0.5, 0.95}),
            "In this image: reported 2 (now 2), graspable 0 (now 2).");
}

TEST(ThresholdPreview, OtherDoubtsPreventAGraspAtAnyThreshold) {
  auto array = found({0.6f, 0.6f});
  array.objects[0].reasons = {"score 0.60 is below confirm_score"};
  array.objects[1].reasons = {"angle open (margin 1.0)"};
  const ThresholdPreview preview(array, {0.5, 0.7});
  EXPECT_EQ(preview.summary({0.5, 0.5}), "In this image: reported 2 (now 2), graspable 1 (now 0).");
}

}  // namespace
}  // namespace mbncc::console
