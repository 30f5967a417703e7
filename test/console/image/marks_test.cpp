// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/marks.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc::console {
namespace {

geometry_msgs::Polygon box(float left, float top, float right, float bottom) {
  geometry_msgs::Polygon polygon;
  for (const auto& [x, y] : {std::pair{left, top}, {right, top}, {right, bottom}, {left, bottom}}) {
    auto& point = polygon.points.emplace_back();
    point.x = x;
    point.y = y;
  }
  return polygon;
}

TEST(Marks, OfDetectionsShowNameScoreAndState) {
  mbncc_vision::DetectedObjectArray detections;
  auto& object = detections.objects.emplace_back();
  object.name = "part";
  object.instance_id = 3;
  object.score = 0.876f;
  object.state = mbncc_vision::DetectedObject::AMBIGUOUS;
  object.outline = box(10, 20, 30, 40);
  const auto marks = marks_of(detections);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_NE(marks[0].label.find("part #3 0.88 ambiguous"), std::string::npos) << marks[0].label;
  EXPECT_EQ(marks[0].level, Level::kDoubtful);
  EXPECT_EQ(marks[0].outlines[0].size(), 4u);
}

TEST(Marks, OfADraftShowEveryPartWhereItLies) {
  mbncc_vision::LearnObjectResult draft;
  draft.object.reference.x = 100;
  draft.object.reference.y = 200;
  draft.object.outline = box(-10, -5, 10, 5);  // the larger part, around the reference
  cv::Mat map(60, 60, CV_8UC1, cv::Scalar(0));
  map(cv::Rect(20, 20, 21, 11)).setTo(255);
  map(cv::Rect(20, 40, 5, 5)).setTo(255);
  draft.map.width = draft.map.height = draft.map.step = 60;
  draft.map.data.assign(map.datastart, map.dataend);
  const auto marks = marks_of(draft);
  ASSERT_EQ(marks.size(), 1u);
  ASSERT_EQ(marks[0].outlines.size(), 2u);
  for (const auto& outline : marks[0].outlines) {
    const cv::Rect place = cv::boundingRect(outline);
    EXPECT_EQ(place.x, 90);
    EXPECT_TRUE(place.y == 195 || place.y == 215) << place.y;
  }
}

TEST(Marks, ADraftWithoutMapHasNone) {
  EXPECT_TRUE(marks_of(mbncc_vision::LearnObjectResult()).empty());
}

}  // namespace
}  // namespace mbncc::console
