// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/overlay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "mbncc/drawing.hpp"
#include "mbncc/matching/overlay.hpp"
#include "nodelets/matching/markers.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;

/// A square of 40 px or 80 mm, rotated by 90 degrees.
mbncc_vision::DetectedObjectArray one(std::uint8_t state) {
  mbncc_vision::DetectedObjectArray array;
  DetectedObject object;
  object.name = "bracket";
  object.state = state;
  object.image_pose.x = object.image_pose.y = 100;
  object.image_pose.theta = CV_PI / 2;
  object.size.x = object.size.y = 0.08;
  object.pose_valid = true;
  object.pose.pose.orientation.w = 1;
  for (const auto& corner : {cv::Point(80, 80), {120, 80}, {120, 120}, {80, 120}}) {
    auto& point = object.outline.points.emplace_back();
    point.x = static_cast<float>(corner.x);
    point.y = static_cast<float>(corner.y);
  }
  for (const auto& corner :
       {cv::Point2f(-0.04f, 0.04f), {-0.04f, -0.04f}, {0.04f, -0.04f}, {0.04f, 0.04f}}) {
    auto& point = object.footprint.points.emplace_back();
    point.x = corner.x;
    point.y = corner.y;
    point.z = 0.02f;
  }
  array.objects.push_back(object);
  return array;
}

int count_of(const cv::Mat& image, const cv::Scalar& colour) {
  cv::Mat same;
  cv::inRange(image, colour, colour, same);
  return cv::countNonZero(same);
}

TEST(Overlay, TheLegendLiesBelowTheImage) {
  const cv::Mat image(240, 320, CV_8UC3, cv::Scalar::all(120));
  const cv::Mat drawn = draw_detections(image, {});
  EXPECT_EQ(drawn.cols, image.cols);
  EXPECT_GT(drawn.rows, image.rows);
  EXPECT_EQ(cv::norm(drawn.rowRange(0, image.rows), image, cv::NORM_INF), 0);
}

/// The columns of the legend in which something is drawn.
cv::Mat written_columns(const cv::Mat& legend) {
  cv::Mat columns, brightest;
  cv::inRange(legend, cv::Scalar::all(30), cv::Scalar::all(30), columns);
  cv::reduce(columns, brightest, 0, cv::REDUCE_MIN);
  return brightest == 0;
}

TEST(Overlay, TheAgeIsSeparateFromTheLegend) {
  for (const int width : {320, 640, 800, 1280, 2448}) {
    const cv::Mat image(240, width, CV_8UC3, cv::Scalar::all(120));
    const auto legend = [&](float latency) {
      mbncc_vision::DetectedObjectArray array;
      array.latency = latency;
      const cv::Mat drawn = draw_detections(image, array);
      return cv::Mat(drawn.rowRange(image.rows, drawn.rows));
    };
    // The two differ in the first digit of the age, which is its leftmost character.
    const cv::Mat young = legend(0.01f), old = legend(8.01f);
    cv::Mat differing;
    cv::reduce(cv::Mat(young != old).reshape(1, young.rows), differing, 0, cv::REDUCE_MAX);
    const int letter = cv::boundingRect(differing).x / 3, gap = width / 160, serif = width / 80;
    const cv::Mat before = written_columns(young).colRange(letter - serif - gap, letter);
    EXPECT_GE(cv::countNonZero(before == 0), gap) << width;
  }
}

TEST(Overlay, TheStateDeterminesTheColour) {
  const cv::Mat image(240, 320, CV_8UC3, cv::Scalar::all(120));
  const auto blue = colour_of(Confidence::kGood), orange = colour_of(Confidence::kDoubtful);
  const cv::Mat confirmed = draw_detections(image, one(DetectedObject::CONFIRMED)).rowRange(0, 240);
  const cv::Mat ambiguous = draw_detections(image, one(DetectedObject::AMBIGUOUS)).rowRange(0, 240);
  EXPECT_GT(count_of(confirmed, blue), 100);
  EXPECT_EQ(count_of(confirmed, orange), 0);
  EXPECT_GT(count_of(ambiguous, orange), 100);
}

TEST(Overlay, AReasonIsBrief) {
  EXPECT_EQ(brief_reason({}), "");
  EXPECT_EQ(brief_reason({"competitor nut at 40, 50 (margin 1.0)", "angle open"}),
            "\ncompetitor nut");
  EXPECT_EQ(brief_reason({"angle open (margin 0.2)"}), "\nangle open");
}

TEST(ScoreMap, MarksTheBestPlaceAndTheNextBestElsewhere) {
  cv::Mat scores(200, 300, CV_32FC1, cv::Scalar(0.1));
  scores.at<float>(100, 80) = 0.9f;
  scores.at<float>(100, 85) = 0.8f;
  scores.at<float>(60, 220) = 0.5f;
  const cv::Mat plain = colour_score_map(scores), drawn = draw_score_map(scores, 30);
  cv::Mat changed;
  cv::absdiff(plain, drawn, changed);
  const auto differs = [&](cv::Rect where) { return cv::sum(changed(where))[0] > 0; };
  EXPECT_TRUE(differs({60, 80, 40, 40}));
  EXPECT_TRUE(differs({205, 45, 30, 30}));
  EXPECT_FALSE(differs({150, 150, 100, 50}));
}

TEST(ScoreMap, ItsLabelsDoNotCoverEachOther) {
  cv::Mat scores(200, 640, CV_32FC1, cv::Scalar(0));
  scores.at<float>(100, 300) = 0.9f;
  const cv::Mat alone = draw_score_map(scores, 30);
  scores.at<float>(100, 240) = 0.5f;
  const cv::Mat both = draw_score_map(scores, 30);
  cv::Mat changed;
  cv::absdiff(alone, both, changed);
  // The ring's label "object" is here; beside its square, the label "next best" would overlap it.
  EXPECT_EQ(cv::sum(changed(cv::Rect(332, 80, 40, 20))), cv::Scalar());
  EXPECT_GT(cv::sum(changed(cv::Rect(270, 105, 100, 60)))[0], 0) << "below it";
}

TEST(Markers, TheOutlineIsInMetresInTheObjectsFrame) {
  const auto markers = to_markers(one(DetectedObject::CONFIRMED)).markers;
  const auto outline = std::find_if(markers.begin(), markers.end(),
                                    [](const auto& marker) { return marker.ns == "outline"; });
  ASSERT_NE(outline, markers.end());
  ASSERT_EQ(outline->points.size(), 5u);  // the outline is closed
  EXPECT_NEAR(outline->points[0].x, -0.04, 1e-6);
  EXPECT_NEAR(outline->points[0].y, 0.04, 1e-6);
  EXPECT_EQ(outline->points[0].z, 0) << "on the top face";
}

TEST(Markers, NoOutlineWithUnknownScale) {
  auto array = one(DetectedObject::CONFIRMED);
  array.objects[0].footprint.points.clear();
  for (const auto& marker : to_markers(array).markers) EXPECT_NE(marker.ns, "outline");
}

TEST(Markers, TheCaptionNamesTheState) {
  const auto markers = to_markers(one(DetectedObject::AMBIGUOUS)).markers;
  EXPECT_NE(markers.back().text.find("ambiguous"), std::string::npos);
}

TEST(Markers, VanishWhenNothingFollows) {
  for (const auto& marker : to_markers(one(DetectedObject::CONFIRMED)).markers)
    EXPECT_TRUE(marker.action == visualization_msgs::Marker::DELETEALL ||
                marker.lifetime > ros::Duration(0));
}

TEST(Markers, NothingWithoutAMetricPose) {
  auto array = one(DetectedObject::CONFIRMED);
  array.objects[0].pose_valid = false;
  EXPECT_EQ(to_markers(array).markers.size(), 1u);
}

}  // namespace
}  // namespace mbncc::nodelets
