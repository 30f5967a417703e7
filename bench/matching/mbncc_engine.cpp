#include "matching/mbncc_engine.hpp"

#include <utility>

namespace mbncc::bench {

MbnccEngine::MbnccEngine(SearchConfig config, std::optional<double> floor)
    : floor_(floor), matcher_(std::move(config)) {}

void MbnccEngine::teach(const cv::Mat& picture, const cv::Mat& map, cv::Point2d reference) {
  auto object = std::make_shared<ObjectModel>();
  object->name = "object";
  object->views.push_back(crop_view(picture, map, {reference.x, reference.y, 0}));
  matcher_.set_objects({std::move(object)});
}

std::vector<Found> MbnccEngine::find(const cv::Mat& picture) {
  SearchRequest request;
  request.min_score = floor_.value_or(matcher_.config().min_score);
  std::vector<Found> found;
  for (const auto& match : matcher_.find(picture, request).matches)
    found.push_back({match.pose, match.score, match.graspable, match.covariance});
  return found;
}

std::optional<double> MbnccEngine::threshold() const {
  return floor_ ? std::nullopt : std::make_optional(matcher_.config().min_score);
}

}  // namespace mbncc::bench
