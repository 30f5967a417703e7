// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/object_model.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace mbncc::test {
namespace {

const cv::Size kSize(160, 120);

cv::Mat image() {
  cv::Mat noise(kSize, CV_8UC3);
  cv::RNG(3).fill(noise, cv::RNG::UNIFORM, 0, 256);
  return noise;
}

cv::Mat disc(cv::Point centre, int radius) {
  cv::Mat map = cv::Mat::zeros(kSize, CV_8UC1);
  cv::circle(map, centre, radius, cv::Scalar(255), cv::FILLED);
  return map;
}

ObjectModel sound_model() {
  ObjectModel model;
  model.name = "wrench";
  model.label = "Wrench 10";
  model.views = {crop_view(image(), disc({70, 60}, 20), {70, 60, 0})};
  return model;
}

TEST(Names, AreSafeAsFileNamesAndFrameNames) {
  for (const char* name : {"a", "Wrench_10", "Z9"}) EXPECT_TRUE(is_valid_name(name)) << name;
  EXPECT_TRUE(is_valid_name(std::string(64, 'a')));
  for (const std::string& name :
       {std::string(), std::string("1a"), std::string("_a"), std::string("../a"),
        std::string("a b"), std::string("a/b"), std::string("a.b"), std::string("a\0b", 3),
        std::string("\xc3\xa4"), std::string(65, 'a'), std::string(10000, 'a'), std::string("a\n")})
    EXPECT_FALSE(is_valid_name(name)) << name;
}

TEST(CropView, KeepsImagePlaceAndMap) {
  for (const cv::Point centre : {cv::Point(70, 60), cv::Point(21, 21), cv::Point(139, 99)}) {
    const cv::Mat map = disc(centre, 20);
    const View view = crop_view(image(), map, {1, 2, 3});
    const cv::Rect crop(view.origin, view.map.size());
    EXPECT_EQ(cv::norm(view.template_image, image()(crop), cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(full_size_map(view), map, cv::NORM_INF), 0);
    for (const cv::Rect part : {cv::Rect(0, 0, 40, 30), cv::Rect(25, 20, 60, 50)})
      EXPECT_EQ(cv::norm(map_within(view, part), map(part), cv::NORM_INF), 0);
    EXPECT_EQ(view.image_size, kSize);
  }
  EXPECT_THROW(crop_view(image(), cv::Mat::zeros(5, 5, CV_8UC1), {}), std::invalid_argument);
  EXPECT_THROW(crop_view(image(), cv::Mat::zeros(kSize, CV_8UC1), {}), std::invalid_argument);
}

TEST(Outlines, LieInTheObjectFrame) {
  View view = crop_view(image(), disc({70, 60}, 20), {70, 60, kPi / 2});
  const auto round = outlines(view);
  ASSERT_EQ(round.size(), 1u);
  for (const auto& point : round[0]) EXPECT_NEAR(cv::norm(point), 20, 1.5);
  view.reference = {70 - 100, 60, kPi / 2};
  // The disc lies at image x +100, which is -y in a frame turned by 90 degrees.
  const auto moved = outlines(view);
  cv::Point2f mean;
  for (const auto& point : moved[0]) mean += point;
  mean /= static_cast<float>(moved[0].size());
  EXPECT_NEAR(mean.x, 0, 2);
  EXPECT_NEAR(mean.y, -100, 2);
}

/// Gripper pose in the image: position [px] and angle about z [rad].
Pose2D gripper_in_image(const ObjectModel& model) {
  const auto& p = model.grasp->position;
  const auto& q = model.grasp->orientation;
  return compose(
      model.views.front().reference,
      {p[0] / model.metres_per_pixel, p[1] / model.metres_per_pixel, 2 * std::atan2(q[2], q[3])});
}

TEST(MoveReference, KeepsTheGraspInPlace) {
  ObjectModel model = sound_model();
  model.metres_per_pixel = 0.002;
  model.grasp = Grasp{{{0.01, -0.03, -0.1}}, {{0, 0, std::sin(0.2), std::cos(0.2)}}};
  const Pose2D before = gripper_in_image(model);
  move_reference(model, {33, 44, 1.1});
  const Pose2D after = gripper_in_image(model);
  EXPECT_NEAR(after.x, before.x, 1e-9);
  EXPECT_NEAR(after.y, before.y, 1e-9);
  EXPECT_NEAR(angle_distance(after.theta, before.theta), 0, 1e-9);
  EXPECT_EQ(model.grasp->position[2], -0.1);
}

TEST(MoveReference, ATiltedGraspTurnsAboutTheOpticalAxis) {
  ObjectModel model = sound_model();
  model.metres_per_pixel = 0.001;
  model.grasp = Grasp{{{0, 0, 0}}, {{std::sin(0.3), 0, 0, std::cos(0.3)}}};
  Pose2D turned = model.views.front().reference;
  turned.theta += kPi / 2;
  move_reference(model, turned);
  // The gripper's tilt was about the old x axis, which is -y of the new frame.
  const auto& q = model.grasp->orientation;
  EXPECT_NEAR(q[1], -std::sin(0.3) * std::sin(kPi / 4), 1e-9);
  EXPECT_NEAR(q[0], std::sin(0.3) * std::cos(kPi / 4), 1e-9);
  EXPECT_NEAR(q[2], -std::cos(0.3) * std::sin(kPi / 4), 1e-9);
}

TEST(MoveReference, RefusesToMoveAGraspWithoutScale) {
  ObjectModel model = sound_model();
  model.grasp = Grasp{};
  EXPECT_THROW(move_reference(model, {33, 44, 0}), std::invalid_argument);
}

TEST(Validate, NamesEachBrokenRule) {
  EXPECT_NO_THROW(validate(sound_model()));
  const std::vector<std::function<void(ObjectModel&)>> faults = {
      [](ObjectModel& model) { model.name = ""; },
      [](ObjectModel& model) { model.label = std::string(300, 'x'); },
      [](ObjectModel& model) { model.label = "line\nbreak"; },
      [](ObjectModel& model) { model.label = "\xff\xfe"; },
      [](ObjectModel& model) {
        model.label =
            "abc\xe2\x80\xae"
            "cba";
      },
      [](ObjectModel& model) { model.quality.reasons = {"line\nbreak"}; },
      [](ObjectModel& model) { model.quality.advice = {"\x1b[2J"}; },
      [](ObjectModel& model) { model.quality.confusable_with = "../x"; },
      [](ObjectModel& model) { model.object_height = 11; },
      [](ObjectModel& model) { model.metres_per_pixel = 1e9; },
      [](ObjectModel& model) {
        model.grasp = Grasp{{0, 1e9, 0}, {0, 0, 0, 1}};
      },
      [](ObjectModel& model) { model.views[0].reference.y = 1e9; },
      [](ObjectModel& model) {
        model.views[0].image_size = {1000000, 480};
      },
      [](ObjectModel& model) {
        model.views[0].image_size = {16384, 16384};
      },
      [](ObjectModel& model) { model.views.clear(); },
      [](ObjectModel& model) { model.object_height = -1; },
      [](ObjectModel& model) { model.object_height = Quality::kUnknown; },
      [](ObjectModel& model) { model.metres_per_pixel = -1; },
      [](ObjectModel& model) { model.min_score = 0; },
      [](ObjectModel& model) { model.min_score = 1.5; },
      [](ObjectModel& model) { model.symmetry = -1; },
      [](ObjectModel& model) { model.symmetry = 13; },
      [](ObjectModel& model) { model.symmetry = 255; },
      [](ObjectModel& model) {
        model.grasp = Grasp{{0, 0, 0}, {0, 0, 0, 0}};
      },
      [](ObjectModel& model) {
        model.grasp = Grasp{{0, 0, Quality::kUnknown}, {0, 0, 0, 1}};
      },
      [](ObjectModel& model) { model.views[0].map.setTo(0); },
      [](ObjectModel& model) { model.views[0].map.setTo(7); },
      [](ObjectModel& model) { model.views[0].template_image = cv::Mat(); },
      [](ObjectModel& model) { model.views[0].origin.x = -1; },
      [](ObjectModel& model) { model.views[0].origin.x = 1000; },
      [](ObjectModel& model) { model.views[0].reference.x = Quality::kUnknown; },
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    ObjectModel model = sound_model();
    model.views[0].map = model.views[0].map.clone();
    faults[i](model);
    EXPECT_THROW(validate(model), std::invalid_argument) << "fault " << i;
  }
}

}  // namespace
}  // namespace mbncc::test
