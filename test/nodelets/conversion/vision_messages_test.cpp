// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/vision/vision_messages.hpp"

#include <gtest/gtest.h>
#include <vision_msgs/VisionInfo.h>

#include <cmath>
#include <string>
#include <utility>

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

constexpr double kTheta = 0.4;

template <class Points>
void add_corner(Points& points, double x, double y, double z) {
  auto& point = points.emplace_back();
  point.x = static_cast<float>(x);
  point.y = static_cast<float>(y);
  point.z = static_cast<float>(z);
}

/// 60 x 20 px or mm, 30 mm high; the reference point lies 10 beside the centre.
DetectedObject bar() {
  DetectedObject object;
  object.name = "bar";
  object.state = DetectedObject::CONFIRMED;
  object.score = 0.75f;
  object.pose_valid = true;
  object.pose.pose.position.x = 1;
  object.pose.pose.position.z = 0.5;
  object.pose.pose.orientation.w = 1;
  object.pose.covariance[0] = 1e-6;
  object.image_pose.x = 100;
  object.image_pose.y = 50;
  object.image_pose.theta = kTheta;
  const double c = std::cos(kTheta), s = std::sin(kTheta);
  for (const auto& [x, y] : {std::pair(-20., -10.), {40., -10.}, {40., 10.}, {-20., 10.}}) {
    add_corner(object.outline.points, 100 + c * x - s * y, 50 + s * x + c * y, 0);
    add_corner(object.footprint.points, x / 1000, y / 1000, 0.03);
  }
  return object;
}

DetectedObjectArray array_of(const DetectedObject& object) {
  DetectedObjectArray array;
  array.header.frame_id = "base_link";
  array.header.stamp = ros::Time(7);
  array.objects = {object};
  array.searched = {object.name};
  return array;
}

ObjectIds ids_of(const DetectedObjectArray& array) {
  ObjectIds ids;
  ids.add(array);
  return ids;
}

TEST(VisionMessages, AreThoseOfThePublicPackage) {
  using ros::message_traits::MD5Sum;
  EXPECT_STREQ(MD5Sum<vision_msgs::Detection2DArray>::value(), "402071f61477de256df9f1aa45e6e4c8");
  EXPECT_STREQ(MD5Sum<vision_msgs::Detection3DArray>::value(), "05c51d9aea1fb4cfdc8effb94f197b6f");
  EXPECT_STREQ(MD5Sum<vision_msgs::VisionInfo>::value(), "eee36f8dc558754ceb4ef619179d8b34");
}

TEST(VisionMessages, InTheImageTheBoxIsAlignedWithTheObject) {
  const auto array = array_of(bar());
  const auto detections = to_detections_2d(array, ids_of(array));
  ASSERT_EQ(detections.detections.size(), 1u);
  EXPECT_EQ(detections.header, array.header);
  const auto& detection = detections.detections[0];
  EXPECT_EQ(detection.header, array.header);
  EXPECT_NEAR(detection.bbox.size_x, 60, 1e-4);
  EXPECT_NEAR(detection.bbox.size_y, 20, 1e-4);
  EXPECT_NEAR(detection.bbox.center.x, 100 + 10 * std::cos(kTheta), 1e-4);
  EXPECT_NEAR(detection.bbox.center.y, 50 + 10 * std::sin(kTheta), 1e-4);
  EXPECT_EQ(detection.bbox.center.theta, kTheta);
  ASSERT_EQ(detection.results.size(), 1u);
  EXPECT_EQ(detection.results[0].id, object_id("bar"));
  EXPECT_EQ(detection.results[0].score, 0.75);
  EXPECT_EQ(detection.results[0].pose, bar().pose);
}

TEST(VisionMessages, InSpaceTheBoxContainsTheBody) {
  for (const bool out : {false, true}) {
    DetectedObject object = bar();
    if (out) {
      object.pose.pose.orientation.x = 1;
      object.pose.pose.orientation.w = 0;
      for (auto& corner : object.footprint.points) corner.z = -corner.z;
    }
    const auto array = array_of(object);
    const auto detections = to_detections_3d(array, ids_of(array));
    ASSERT_EQ(detections.detections.size(), 1u);
    const auto& box = detections.detections[0].bbox;
    EXPECT_NEAR(box.center.position.x, 1.01, 1e-6);
    EXPECT_NEAR(box.center.position.y, 0, 1e-6);
    EXPECT_NEAR(box.center.position.z, 0.515, 1e-6) << "between top face and platform";
    EXPECT_NEAR(box.size.x, 0.06, 1e-6);
    EXPECT_NEAR(box.size.y, 0.02, 1e-6);
    EXPECT_NEAR(box.size.z, 0.03, 1e-6);
    EXPECT_EQ(detections.detections[0].results[0].pose, object.pose);
  }
}

TEST(VisionMessages, WithUnknownScaleTheBoxHasNoSize) {
  DetectedObject object = bar();
  object.footprint.points.clear();
  const auto array = array_of(object);
  const auto box = to_detections_3d(array, ids_of(array)).detections.at(0).bbox;
  EXPECT_EQ(box.size.x, 0);
  EXPECT_EQ(box.center, object.pose.pose);
}

TEST(VisionMessages, UnconfirmedObjectsAreOmitted) {
  for (const std::uint8_t state :
       {DetectedObject::NEW, DetectedObject::AMBIGUOUS, DetectedObject::HELD}) {
    DetectedObject object = bar();
    object.state = state;
    const auto array = array_of(object);
    EXPECT_TRUE(to_detections_2d(array, ids_of(array)).detections.empty());
    EXPECT_TRUE(to_detections_3d(array, ids_of(array)).detections.empty());
  }
}

TEST(VisionMessages, WithoutMetresOnlyTheImageMessageIsFilled) {
  DetectedObject object = bar();
  object.pose_valid = false;
  object.pose.pose.position.x = std::nan("");
  auto array = array_of(object);
  array.status = DetectedObjectArray::UNCALIBRATED;
  const auto detections = to_detections_2d(array, ids_of(array));
  ASSERT_EQ(detections.detections.size(), 1u);
  EXPECT_EQ(detections.detections[0].results[0].pose, geometry_msgs::PoseWithCovariance());
  EXPECT_TRUE(to_detections_3d(array, ids_of(array)).detections.empty());
  for (const int status : {1, 5, 6, 200}) {
    array.status = static_cast<std::uint8_t>(status);
    EXPECT_TRUE(to_detections_2d(array, ids_of(array)).detections.empty()) << status;
  }
}

TEST(ObjectIds, AreTheNamesChecksums) {
  EXPECT_EQ(object_id("bracket"), 0x410e266e) << "zlib.crc32(b'bracket')";
}

TEST(ObjectIds, ReportNewNames) {
  ObjectIds ids;
  const auto array = array_of(bar());
  EXPECT_FALSE(ids.has("bar"));
  EXPECT_TRUE(ids.add(array));
  EXPECT_FALSE(ids.add(array));
  EXPECT_TRUE(ids.has("bar"));
  EXPECT_EQ(ids.names().at(object_id("bar")), "bar");
}

TEST(ObjectIds, OmitTheSecondOfTwoNamesWithOneNumber) {
  const std::string first = "part_150239268", second = "part_1195475997";
  ASSERT_EQ(object_id(first), object_id(second));
  DetectedObject one = bar(), other = bar();
  one.name = first;
  other.name = second;
  auto array = array_of(one);
  array.objects.push_back(other);
  const auto ids = ids_of(array);
  EXPECT_FALSE(ids.has(second));
  EXPECT_EQ(to_detections_2d(array, ids).detections.size(), 1u);
  EXPECT_EQ(to_detections_3d(array, ids).detections.size(), 1u);
}

}  // namespace
}  // namespace mbncc::nodelets
