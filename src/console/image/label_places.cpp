// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/label_places.hpp"

#include <algorithm>
#include <limits>

namespace mbncc::console {
namespace {

constexpr int kGap = 4;      // [px] between an object and its label
constexpr int kRings = 6;    // number of distances that are tried
constexpr double kFar = 20;  // [px^2] overlap that costs as much as one more ring of distance

cv::Rect moved_inside(cv::Rect label, const cv::Rect& room) {
  label.x = std::max(room.x, std::min(label.x, room.br().x - label.width));
  label.y = std::max(room.y, std::min(label.y, room.br().y - label.height));
  return label;
}

/// Positions above, below, right and left of the object, then at its corners, `away` [px] from it.
std::vector<cv::Rect> places_about(const LabelledThing& thing, int away) {
  const cv::Rect& box = thing.box;
  const cv::Size& size = thing.label;
  const int middle_x = box.x + (box.width - size.width) / 2,
            middle_y = box.y + (box.height - size.height) / 2;
  const int left = box.x - size.width - away, right = box.br().x + away,
            top = box.y - size.height - away, bottom = box.br().y + away;
  std::vector<cv::Rect> places;
  for (const cv::Point& corner :
       {cv::Point(middle_x, top), cv::Point(middle_x, bottom), cv::Point(right, middle_y),
        cv::Point(left, middle_y), cv::Point(right, top), cv::Point(left, top),
        cv::Point(right, bottom), cv::Point(left, bottom)})
    places.emplace_back(corner, size);
  return places;
}

}  // namespace

std::vector<cv::Rect> place_labels(const std::vector<LabelledThing>& things, const cv::Rect& room) {
  std::vector<cv::Rect> placed;
  for (const auto& thing : things) {
    cv::Rect best;
    double least = std::numeric_limits<double>::max();
    for (int ring = 0; ring < kRings; ++ring)
      for (const auto& wish : places_about(thing, kGap + ring * thing.label.height)) {
        const cv::Rect place = moved_inside(wish, room);
        double cost = kFar * ring;
        for (const auto& other : placed) cost += 4 * (place & other).area();
        for (const auto& other : things) cost += (place & other.box).area();
        if (cost < least) {
          least = cost;
          best = place;
        }
      }
    placed.push_back(best);
  }
  return placed;
}

}  // namespace mbncc::console
