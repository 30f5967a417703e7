// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/label_places.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

const cv::Rect kRoom(0, 0, 640, 480);

TEST(LabelPlaces, ALabelLiesBesideItsObjectWithinTheBounds) {
  for (const cv::Point& corner : {cv::Point(300, 200), cv::Point(0, 0), cv::Point(600, 450)}) {
    const cv::Rect box(corner, cv::Size(40, 30));
    const auto places = place_labels({{box, {120, 20}}}, kRoom);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ((places[0] & box).area(), 0);
    EXPECT_EQ(places[0] & kRoom, places[0]);
  }
}

TEST(LabelPlaces, LabelsOfNeighboursDoNotOverlap) {
  std::vector<LabelledThing> things;
  for (int i = 0; i < 4; ++i) things.push_back({{200 + 60 * i, 200, 50, 50}, {130, 20}});
  const auto places = place_labels(things, kRoom);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const auto& thing : things) EXPECT_EQ((places[i] & thing.box).area(), 0);
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ((places[i] & places[j]).area(), 0);
  }
}

TEST(LabelPlaces, ALabelIsPlacedEvenIfTheBoundsAreTooSmall) {
  EXPECT_EQ(place_labels({{{0, 0, 30, 30}, {500, 20}}}, {0, 0, 40, 40}).size(), 1u);
}

}  // namespace
}  // namespace mbncc::console
