// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/resemblance.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "mbncc/learning/further_view.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::test {
namespace {

sim::Placed placed(std::uint64_t seed, const Pose2D& pose) {
  sim::SceneObject object;
  object.seed = seed;
  return {object, pose};
}

const sim::Scene& scene() {
  static const sim::Scene drawn;
  return drawn;
}

ObjectModel learned(const std::string& name, const sim::Placed& object, const cv::Mat& image) {
  ObjectModel model;
  model.name = model.label = name;
  model.views = {crop_view(image, scene().true_map(object),
                           {object.pose.x, object.pose.y, object.pose.theta})};
  return model;
}

TEST(Resemblance, ViewsOfOneObjectGetOneFrame) {
  const auto first = placed(5, {200, 200, 0}), second = placed(5, {420, 260, 2});
  const cv::Mat before = scene().render({first}, 1), later = scene().render({second}, 2);
  const ObjectModel stored = learned("part", first, before);
  View view = learned("part", second, later).views[0];
  view.reference = {};
  const auto match = match_in_view(stored, view, later);
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->pose.x, 420, 1);
  EXPECT_NEAR(match->pose.y, 260, 1);
  EXPECT_NEAR(angle_distance(match->pose.theta, 2), 0, to_radians(1.5));
}

TEST(Resemblance, AnotherObjectIsRefusedAsAView) {
  const auto first = placed(5, {200, 200, 0}), other = placed(77, {200, 200, 0});
  const cv::Mat before = scene().render({first}, 1);
  // The stored object is in the image, but not in the map.
  const cv::Mat later = scene().render({other, placed(5, {450, 300, 1})}, 2);
  const ObjectModel stored = learned("part", first, before);
  EXPECT_FALSE(match_in_view(stored, learned("part", other, later).views[0], later));
}

/// A ring with a hole of radius `hole` [px], at `place` in a larger image.
ObjectModel ring(const std::string& name, cv::Point place, cv::Mat& image, int hole = 33) {
  image = cv::Mat(240, 320, CV_8UC3, cv::Scalar(150, 150, 150));
  cv::Mat map = cv::Mat::zeros(image.size(), CV_8UC1);
  cv::circle(map, place, 40, cv::Scalar(255), cv::FILLED);
  if (hole > 0) cv::circle(map, place, hole, cv::Scalar(0), cv::FILLED);
  image.setTo(cv::Scalar(40, 60, 170), map);
  ObjectModel model;
  model.name = model.label = name;
  model.views = {crop_view(image, map, {double(place.x), double(place.y), 0})};
  return model;
}

// Its outline alone has no hole.
TEST(Resemblance, AViewOfARingIsComparedWithItsHole) {
  cv::Mat before, later;
  const ObjectModel stored = ring("ring", {100, 100}, before);
  const View view = ring("ring", {200, 130}, later).views[0];
  const auto match = match_in_view(stored, view, later);
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->pose.x, 200, 1);
  EXPECT_NEAR(match->pose.y, 130, 1);
  EXPECT_FALSE(match_in_view(ring("disc", {100, 100}, before, 0), view, later));
}

TEST(Resemblance, DoesNotDependOnTheFrameOfAKnownObjectNorOnTheTimeBudget) {
  const auto first = placed(5, {200, 200, 0}), other = placed(77, {430, 250, 0});
  const cv::Mat image = scene().render({first, other}, 1);
  ObjectModel far = learned("part", first, image);
  move_reference(far, {-300, 900, 1});
  const std::vector<std::shared_ptr<const ObjectModel>> library = {
      std::make_shared<const ObjectModel>(learned("other", other, image)),
      std::make_shared<const ObjectModel>(far)};
  const auto again = placed(5, {300, 320, 1.3});
  const cv::Mat later = scene().render({again}, 3);
  ObjectModel twin = learned("twin", again, later);
  SearchConfig hurried;
  hurried.time_budget = 1e-9;
  note_resemblance(twin, later, library, hurried);
  EXPECT_EQ(twin.quality.confusable_with, "part");
}

TEST(Resemblance, TheMostSimilarKnownObjectIsReported) {
  const auto first = placed(5, {200, 200, 0}), other = placed(77, {430, 250, 0});
  const cv::Mat image = scene().render({first, other}, 1);
  const auto known = [](const ObjectModel& model) {
    return std::make_shared<const ObjectModel>(model);
  };
  const std::vector<std::shared_ptr<const ObjectModel>> library = {
      known(learned("other", other, image)), known(learned("part", first, image))};

  const auto again = placed(5, {300, 320, 1.3});
  const cv::Mat later = scene().render({again}, 3);
  ObjectModel twin = learned("twin", again, later);
  note_resemblance(twin, later, library);
  EXPECT_EQ(twin.quality.confusable_with, "part");
  EXPECT_EQ(twin.quality.verdict, Verdict::kMarginal);
  ASSERT_EQ(twin.quality.reasons, std::vector<std::string>{"resembles_known"});
  EXPECT_NE(twin.quality.advice[0].find("'part'"), std::string::npos);

  ObjectModel same_name = learned("part", again, later);
  note_resemblance(same_name, later, {library[1]});
  EXPECT_EQ(same_name.quality.confusable_with, "");
  EXPECT_EQ(same_name.quality.verdict, Verdict::kGood);
}

}  // namespace
}  // namespace mbncc::test
