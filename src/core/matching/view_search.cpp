#include "matching/view_search.hpp"

#include <algorithm>
#include <cmath>

#include "matching/coarse_search.hpp"
#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

constexpr int kFirstIterations = 6;  // of refinement, at the level of the coarse search
constexpr int kOtherIterations = 4;  // at finer levels
constexpr int kLastIterations = 10;  // at full resolution

std::size_t most_at(int level) {
  return level == 0 ? 24 : level == 1 ? 48 : 120;
}

cv::Rect at_level(const cv::Rect& roi, int level) {
  const int side = 1 << level;
  const cv::Point low(roi.x / side, roi.y / side);
  const cv::Point high((roi.br().x + side - 1) / side, (roi.br().y + side - 1) / side);
  return {low, high};
}

void refine_at(const PreparedView& view, const ScenePicture& scene, int level, int iterations,
               std::vector<Candidate>& candidates) {
  for (auto& candidate : candidates) {
    const RefinedPose refined =
        view.refiners[level].refine(scene.grey[level], candidate.pose, iterations);
    candidate.pose = refined.pose;
    candidate.value = refined.similarity;
  }
  drop_duplicates(candidates, 1.0, view.shape.radius() / (1 << level), most_at(level));
}

void step_down(std::vector<Candidate>& candidates) {
  for (auto& candidate : candidates) {
    candidate.pose = from_level(candidate.pose, 1);
    --candidate.level;
  }
}

Detection judged(const PreparedObject& object, const PreparedView& view, const ScenePicture& scene,
                 const Candidate& candidate) {
  const RefinedPose refined =
      view.refiners[0].refine(scene.grey[0], candidate.pose, kLastIterations);
  Detection detection;
  detection.object = &object;
  detection.view = &view;
  detection.pose = refined.pose;
  detection.covariance = refined.covariance;
  const Similarity similar = similarity(view.points, scene.grey[0], refined.pose);
  detection.similarity = similar.value;
  detection.visible = similar.visible;
  detection.log_odds = 30 * (similar.value - 0.8) + 0.6 * (std::log(view.shape.area()) - 8);
  return detection;
}

}  // namespace

double Detection::score() const {
  return 1 / (1 + std::exp(-log_odds));
}

std::vector<Detection> search_view(const PreparedObject& object, const PreparedView& view,
                                   const ScenePicture& scene, const cv::Rect& roi) {
  const int top = view.top_level();
  if (top > scene.top_level()) return {};
  auto candidates = coarse_search(view.kernels, scene.grey[top], at_level(roi, top));
  for (int level = top; level > 0; --level) {
    refine_at(view, scene, level, level == top ? kFirstIterations : kOtherIterations, candidates);
    step_down(candidates);
  }
  refine_at(view, scene, 0, kOtherIterations, candidates);
  std::vector<Detection> detections;
  for (const auto& candidate : candidates)
    detections.push_back(judged(object, view, scene, candidate));
  std::stable_sort(detections.begin(), detections.end(),
                   [](const Detection& a, const Detection& b) { return a.log_odds > b.log_odds; });
  return detections;
}

}  // namespace mbncc
