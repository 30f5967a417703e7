// SPDX-License-Identifier: BSD-3-Clause
// If the lower rows of an image were read after the object moved on, no single pose fits the
// object.
#include <gtest/gtest.h>

#include "mbncc/matching/matcher.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(240, 200);  // [px]

sim::Scene scene_of(std::uint64_t seed) {
  sim::SceneConfig config;
  config.size = kSize;
  config.seed = seed;
  return sim::Scene(config);
}

TEST(TornImage, IsNotGraspableAtAWrongAngle) {
  int found = 0, wrong = 0, whole = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const sim::SceneObject drawing{seed, 60, 2.2};
    const sim::Placed taught{drawing, {120, 100, 0}}, lies{drawing, {118.4, 97.3, 1.2}};
    const sim::Scene lesson = scene_of(50 + seed), scene = scene_of(seed);
    auto model = std::make_shared<ObjectModel>();
    model->name = "part";
    model->views = {crop_view(lesson.render({taught}), lesson.true_map(taught), taught.pose)};
    Matcher matcher;
    matcher.set_objects({model});
    sim::Placed moved = lies;
    for (const double way : {-8., -5., 0., 5., 8.}) {
      moved.pose.x = lies.pose.x + way;
      cv::Mat image = scene.render({lies}, 1);
      scene.render({moved}, 1).rowRange(98, kSize.height).copyTo(image.rowRange(98, kSize.height));
      for (const auto& match : matcher.find(image).matches) {
        if (way == 0) {
          whole += match.graspable;
          continue;
        }
        ++found;
        wrong +=
            match.graspable && angle_distance(match.pose.theta, lies.pose.theta, 1) > to_radians(3);
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "of " << found << " found";
  EXPECT_GT(found, 0);
  EXPECT_GE(whole, 11);
}

}  // namespace
}  // namespace mbncc
