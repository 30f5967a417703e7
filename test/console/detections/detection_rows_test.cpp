// SPDX-License-Identifier: BSD-3-Clause
#include "console/detections/detection_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace mbncc::console {
namespace {

using mbncc_vision::DetectedObject;

mbncc_vision::DetectedObjectArray one(bool metric) {
  mbncc_vision::DetectedObjectArray array;
  DetectedObject object;
  object.name = "bracket";
  object.instance_id = 3;
  object.state = DetectedObject::CONFIRMED;
  object.score = 0.953f;
  object.symmetry = 1;
  object.image_pose.x = 320.5;
  object.image_pose.theta = CV_PI / 6;
  object.pose_valid = metric;
  object.pose.pose.position.x = 0.0123;
  object.pose.pose.orientation.z = std::sin(CV_PI / 8);
  object.pose.pose.orientation.w = std::cos(CV_PI / 8);
  array.objects.push_back(object);
  return array;
}

TEST(DetectionRows, ShowMillimetresAndDegreesIfCalibrated) {
  const auto rows = detection_rows(one(true), 0.12);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].cells[0], "bracket #3");
  EXPECT_NE(rows[0].cells[1].find("confirmed"), std::string::npos);
  EXPECT_EQ(rows[0].cells[2], "12.3 mm");
  EXPECT_EQ(rows[0].cells[4], "45.0\u00b0");
  EXPECT_EQ(rows[0].cells[5], "0.95");
  EXPECT_EQ(rows[0].cells[6], "0.1 s");
  EXPECT_EQ(rows[0].level, Level::kGood);
}

TEST(DetectionRows, ShowPixelsIfNotCalibrated) {
  const auto rows = detection_rows(one(false), 0);
  EXPECT_EQ(rows[0].cells[2], "320.5 px");
  EXPECT_EQ(rows[0].cells[4], "30.0\u00b0");
}

TEST(DetectionRows, ZeroHasNoSign) {
  auto array = one(false);
  array.objects[0].image_pose.x = -0.04;
  array.objects[0].image_pose.theta = -1e-4;
  EXPECT_EQ(detection_rows(array, 0)[0].cells[2], "0.0 px");
  EXPECT_EQ(detection_rows(array, 0)[0].cells[4], "0.0\u00b0");
}

TEST(DetectionRows, EachReasonHasItsOwnLine) {
  auto array = one(true);
  EXPECT_EQ(detection_rows(array, 0)[0].reasons, "");
  array.objects[0].reasons = {"angle open", "30 % outside"};
  EXPECT_EQ(detection_rows(array, 0)[0].reasons, "angle open\n30 % outside");
}

TEST(DetectionRows, ARoundObjectHasNoAngle) {
  auto array = one(true);
  array.objects[0].symmetry = 0;
  EXPECT_EQ(detection_rows(array, 0)[0].cells[4], "round");
}

TEST(DetectionRows, StatesHaveDifferentWordsAndSymbols) {
  auto array = one(true);
  array.objects[0].state = DetectedObject::AMBIGUOUS;
  const auto ambiguous = detection_rows(array, 0)[0];
  array.objects[0].state = DetectedObject::NEW;
  const auto fresh = detection_rows(array, 0)[0];
  EXPECT_NE(ambiguous.cells[1], fresh.cells[1]);
  EXPECT_NE(ambiguous.level, fresh.level);
}

}  // namespace
}  // namespace mbncc::console
