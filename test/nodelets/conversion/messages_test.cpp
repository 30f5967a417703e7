// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mbncc::nodelets {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// An 80 x 40 px plate learned at reference (100, 90), 0.5 mm per pixel.
ObjectModel plate() {
  ObjectModel model;
  model.name = "plate";
  model.label = "Plate";
  model.revision = 3;
  model.learned_at = 1000.5;
  model.taught_by = "robot7/left";
  model.metres_per_pixel = 0.0005;
  model.object_height = 0.01;
  View view;
  view.template_image = cv::Mat(60, 200, CV_8UC3, cv::Scalar(1, 2, 3));
  view.map = cv::Mat::zeros(60, 200, CV_8UC1);
  view.map(cv::Rect(10, 10, 81, 41)).setTo(255);
  view.origin = {50, 60};
  view.image_size = {640, 480};
  view.reference = {100, 90, 0};
  model.views.push_back(view);
  return model;
}

TEST(LearnedObjectMessage, CarriesTheModel) {
  const auto message = to_msg(plate(), true);
  EXPECT_EQ(message.name, "plate");
  EXPECT_EQ(message.revision, 3u);
  EXPECT_EQ(message.views, 1u);
  EXPECT_DOUBLE_EQ(message.learned_at.toSec(), 1000.5);
  EXPECT_EQ(message.taught_by, "robot7/left");
  EXPECT_EQ(message.image_width, 640u);
  EXPECT_EQ(message.image_height, 480u);
  EXPECT_FALSE(message.has_grasp);
  EXPECT_EQ(message.min_score, 0);
  EXPECT_NEAR(message.size.x, 0.04, 1e-9);
  EXPECT_NEAR(message.size.y, 0.02, 1e-9);
  EXPECT_NEAR(message.size.z, 0.01, 1e-9);
  EXPECT_EQ(message.outline.points.size(), 4u);
  EXPECT_LE(message.thumbnail.width, 160u);
  EXPECT_EQ(message.thumbnail.height, 48u);
}

TEST(LearnedObjectMessage, CarriesTheDeclaredSymmetry) {
  ObjectModel model = plate();
  EXPECT_EQ(to_msg(model, false).symmetry, 0);
  const std::pair<int, int> values[] = {{1, 1}, {2, 2}, {3, 3}, {5, 5}, {12, 12}, {0, 255}};
  for (const auto& [symmetry, told] : values) {
    model.symmetry = symmetry;
    EXPECT_EQ(to_msg(model, false).symmetry, told);
    EXPECT_EQ(symmetry_from_msg(static_cast<std::uint8_t>(told)), symmetry);
  }
  EXPECT_EQ(symmetry_from_msg(0), std::nullopt);
  for (const int wrong : {13, 100, 254})
    EXPECT_THROW(symmetry_from_msg(static_cast<std::uint8_t>(wrong)), std::invalid_argument);
}

TEST(LearnedObjectMessage, CarriesEveryTimeThatAFileMayContain) {
  ObjectModel model = plate();
  model.learned_at = 4e9;
  EXPECT_EQ(to_msg(model, false).learned_at.sec, 4000000000u);
}

TEST(LearnedObjectMessage, LeavesTheThumbnailOut) {
  EXPECT_TRUE(to_msg(plate(), false).thumbnail.data.empty());
}

TEST(LearnedObjectMessage, HasNoSizeWithoutScale) {
  ObjectModel model = plate();
  model.metres_per_pixel = Quality::kUnknown;
  const auto size = to_msg(model, false).size;
  EXPECT_TRUE(std::isnan(size.x) && std::isnan(size.y) && std::isnan(size.z));
}

TEST(DetectedObjectMessage, HasNoMetricPoseByItself) {
  Match match;
  match.name = "plate";
  match.pose = {12, 34, 0.5};
  match.covariance = cv::Matx33d(1, 2, 3, 4, 5, 6, 7, 8, 9);
  match.score = 0.8;
  match.outline = {{1, 2}, {3, 4}, {5, 7}};
  const ObjectModel model = plate();
  const auto message = to_msg(match, &model);
  EXPECT_FALSE(message.pose_valid);
  EXPECT_TRUE(std::isnan(message.pose.pose.position.x));
  EXPECT_TRUE(std::isnan(message.pose.pose.orientation.w));
  EXPECT_EQ(message.child_frame_id, "");
  EXPECT_EQ(message.state, mbncc_vision::DetectedObject::NEW);
  EXPECT_DOUBLE_EQ(message.image_pose.theta, 0.5);
  EXPECT_DOUBLE_EQ(message.image_pose_covariance[1], 2);
  EXPECT_DOUBLE_EQ(message.image_pose_covariance[6], 7);
  EXPECT_NEAR(message.size.x, 0.04, 1e-9);
  EXPECT_EQ(message.outline.points.size(), 3u);
}

TEST(DetectedObjectMessage, ReportsAnAmbiguousMatch) {
  Match match;
  match.ambiguous = true;
  EXPECT_EQ(to_msg(match, nullptr).state, mbncc_vision::DetectedObject::AMBIGUOUS);
  EXPECT_TRUE(std::isnan(to_msg(match, nullptr).size.x));
}

TEST(RegionOfInterest, ReadsBack) {
  const cv::Rect region(3, 4, 50, 60);
  EXPECT_EQ(from_msg(to_msg(region), {640, 480}), region);
}

TEST(RegionOfInterest, OfZeroSizeIsTheWholeImage) {
  const auto region = from_msg(sensor_msgs::RegionOfInterest{}, {640, 480});
  ASSERT_TRUE(region);
  EXPECT_TRUE(region->empty());
}

TEST(RegionOfInterest, OutsideTheImageIsRefused) {
  sensor_msgs::RegionOfInterest region;
  const auto refused = [&region](std::uint32_t x, std::uint32_t y, std::uint32_t w,
                                 std::uint32_t h) {
    region.x_offset = x, region.y_offset = y, region.width = w, region.height = h;
    return !from_msg(region, {640, 480});
  };
  EXPECT_FALSE(refused(0, 0, 640, 480));
  EXPECT_TRUE(refused(1, 0, 640, 480));
  EXPECT_TRUE(refused(0, 0, 640, 481));
  EXPECT_TRUE(refused(5, 5, 0, 10));
  EXPECT_TRUE(refused(5, 5, 10, 0));
  EXPECT_TRUE(refused(0xffffffffu, 0, 2, 2));
  EXPECT_TRUE(refused(1, 1, 0xffffffffu, 0xffffffffu));
}

TEST(Pose2DMessage, RefusesNumbersThatAreNotFinite) {
  EXPECT_TRUE(from_msg(to_msg(Pose2D{1, 2, 3})));
  EXPECT_FALSE(from_msg(to_msg(Pose2D{kNaN, 2, 3})));
  EXPECT_FALSE(from_msg(to_msg(Pose2D{1, 2, kNaN})));
  EXPECT_FALSE(from_msg(to_msg(Pose2D{1, std::numeric_limits<double>::infinity(), 3})));
}

TEST(PolygonMessage, ReadsBackAndRefusesNaN) {
  const std::vector<cv::Point2f> corners{{1, 2}, {3, 4}, {5, 7}};
  EXPECT_EQ(from_msg(to_msg(corners)), corners);
  auto message = to_msg(corners);
  message.points[1].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(from_msg(message));
}

TEST(GraspMessage, NeedsAUnitQuaternion) {
  Grasp grasp;
  grasp.position = {{0.1, 0.2, 0.3}};
  ASSERT_TRUE(from_msg(to_msg(grasp)));
  EXPECT_EQ(from_msg(to_msg(grasp))->position, grasp.position);
  EXPECT_FALSE(from_msg(geometry_msgs::Pose{}));  // quaternion of zeros
  grasp.position = {{0.1, -11, 0.3}};
  EXPECT_FALSE(from_msg(to_msg(grasp))) << "beyond any reach";
  grasp.orientation = {{0, 0, kNaN, 1}};
  EXPECT_FALSE(from_msg(to_msg(grasp)));
}

}  // namespace
}  // namespace mbncc::nodelets
