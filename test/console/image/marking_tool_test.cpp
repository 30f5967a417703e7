// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/marking_tool.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

const cv::Size kImage(640, 480);

std::optional<MarkingTool::Request> drag(MarkingTool& tool, std::vector<cv::Point2f> way) {
  tool.press(way.front());
  for (const auto& point : way) tool.move(point);
  return tool.release(way.back(), kImage);
}

TEST(MarkingTool, DrawsNothingUnlessAToolIsChosen) {
  MarkingTool tool;
  EXPECT_FALSE(drag(tool, {{10, 10}, {50, 50}}));
}

TEST(MarkingTool, AStrokeKeepsItsPathAndWidth) {
  for (const Tool kind : {Tool::kInclude, Tool::kExclude}) {
    MarkingTool tool;
    tool.choose(kind);
    tool.set_stroke_width(12);
    const auto request = drag(tool, {{10, 10}, {30, 10}, {30, 40}});
    ASSERT_TRUE(request);
    EXPECT_EQ(request->command, MarkingTool::Request::EDIT);
    EXPECT_FLOAT_EQ(request->stroke_width, 12);
    const auto& drawn = kind == Tool::kInclude ? request->include : request->exclude;
    const auto& other = kind == Tool::kInclude ? request->exclude : request->include;
    EXPECT_TRUE(other.empty());
    ASSERT_EQ(drawn.size(), 1u);
    ASSERT_EQ(drawn[0].points.size(), 3u);
    EXPECT_FLOAT_EQ(drawn[0].points[2].y, 40);
  }
}

TEST(MarkingTool, AClickDrawsNothing) {
  MarkingTool tool;
  tool.choose(Tool::kInclude);
  EXPECT_FALSE(drag(tool, {{10, 10}}));
  EXPECT_FALSE(drag(tool, {{10, 10}, {11, 11}})) << "nor does a slip of the mouse";
}

TEST(MarkingTool, ADrawingCanBeCancelled) {
  MarkingTool tool;
  tool.choose(Tool::kInclude);
  EXPECT_FALSE(tool.give_up());
  tool.press({10, 10});
  tool.move({50, 50});
  EXPECT_TRUE(tool.give_up());
  EXPECT_FALSE(tool.release({50, 50}, kImage));
}

TEST(MarkingTool, ARegionIsTheSameFromAnyCornerAndClipped) {
  for (const auto& way :
       std::vector<std::vector<cv::Point2f>>{{{100, 50}, {900, 200}}, {{900, 200}, {100, 50}}}) {
    MarkingTool tool;
    tool.choose(Tool::kRegion);
    const auto request = drag(tool, way);
    ASSERT_TRUE(request);
    EXPECT_EQ(request->roi.x_offset, 100u);
    EXPECT_EQ(request->roi.y_offset, 50u);
    EXPECT_EQ(request->roi.width, 540u);
    EXPECT_EQ(request->roi.height, 150u);
  }
}

TEST(MarkingTool, AVeryShortDragIsNoRegion) {
  MarkingTool tool;
  tool.choose(Tool::kRegion);
  EXPECT_FALSE(drag(tool, {{10, 10}, {11, 11}}));
}

TEST(MarkingTool, AxesAreMovedByTheirOriginAndTurnedByTheirTip) {
  geometry_msgs::Pose2D axes;
  axes.x = 100;
  axes.y = 100;
  MarkingTool tool;
  tool.choose(Tool::kAxes);
  tool.set_axes(axes, 40);
  const auto moved = drag(tool, {{100, 100}, {110, 95}});
  ASSERT_TRUE(moved && moved->set_reference);
  EXPECT_NEAR(moved->reference.x, 110, 1e-4);
  EXPECT_NEAR(moved->reference.y, 95, 1e-4);
  EXPECT_NEAR(moved->reference.theta, 0, 1e-9);

  tool.set_axes(axes, 40);
  const auto turned = drag(tool, {{140, 100}, {100, 140}});
  ASSERT_TRUE(turned && turned->set_reference);
  EXPECT_NEAR(turned->reference.theta, CV_PI / 2, 1e-6);
  EXPECT_NEAR(turned->reference.x, 100, 1e-9);
}

TEST(MarkingTool, AxesAreNotResetWhileDragged) {
  MarkingTool tool;
  tool.choose(Tool::kAxes);
  tool.set_axes({}, 40);
  tool.press({0, 0});
  tool.move({7, 0});
  tool.set_axes({}, 40);
  EXPECT_NEAR(tool.axes().x, 7, 1e-9);
}

}  // namespace
}  // namespace mbncc::console
