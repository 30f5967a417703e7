// SPDX-License-Identifier: BSD-3-Clause
#include "matching/mbncc_engine.hpp"

#include <utility>

namespace mbncc::bench {

void MbnccEngine::teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) {
  auto object = std::make_shared<ObjectModel>();
  object->name = "object";
  object->views.push_back(crop_view(image, map, {reference.x, reference.y, 0}));
  matcher_.set_objects({std::move(object)});
}

std::vector<Found> MbnccEngine::find(const cv::Mat& image) {
  std::vector<Found> found;
  for (const auto& match : matcher_.find(image).matches)
    found.push_back({match.pose, match.score, match.graspable, match.covariance});
  return found;
}

}  // namespace mbncc::bench
