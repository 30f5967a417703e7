// SPDX-License-Identifier: BSD-3-Clause
// Tests that a graspable instance was compared with its competitors.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "matching/images.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

TEST(Margins, EveryInstanceIsComparedWithItsOwnOtherAngles) {
  cv::Mat map = cv::Mat::zeros(60, 60, CV_8UC1);
  cv::circle(map, {30, 30}, 22, 255, cv::FILLED);
  test::LearningImage source(3, map);
  // With little texture, nearly any angle fits.
  source.surface.convertTo(source.surface, -1, 0.15, 120);
  source.surface.copyTo(source.image, map);
  const Pose2D reference{30, 30, 0};
  Matcher matcher;
  matcher.set_objects({test::object_from(source, reference)});
  cv::Mat scene = test::texture({400, 300}, 50, 4);
  for (int k = 0; k < 6; ++k)
    test::place(scene, source, reference.position(),
                {60.3 + 130 * (k % 3), 80.7 + 140 * (k / 3), 1.1 * k - 3});
  const auto matches = matcher.find(scene).matches;
  ASSERT_EQ(matches.size(), 6u);
  for (const auto& match : matches) EXPECT_LT(match.margin_angle, 20) << match.pose.x;
}

}  // namespace
}  // namespace mbncc
