// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scene_cache.hpp"

#include <algorithm>

namespace mbncc::sim {
namespace {

constexpr std::size_t kDrawings = 64;

bool same(const SceneObject& a, const SceneObject& b) {
  return a.seed == b.seed && a.diameter == b.diameter && a.elongation == b.elongation;
}

bool same(const Placed& a, const Placed& b) {
  return same(a.object, b.object) && a.pose.x == b.pose.x && a.pose.y == b.pose.y &&
         a.pose.theta == b.pose.theta;
}

}  // namespace

std::shared_ptr<const Drawing> SceneCache::drawing(const SceneObject& object) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& entry : drawings_)
    if (same(entry.object, object)) return entry.drawing;
  if (drawings_.size() == kDrawings) drawings_.erase(drawings_.begin());
  drawings_.push_back({object, std::make_shared<const Drawing>(draw_object(object))});
  return drawings_.back().drawing;
}

cv::Mat SceneCache::composition(const std::vector<Placed>& placed,
                                const std::function<cv::Mat()>& compose) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool known = !composition_.empty() &&
                       std::equal(placed.begin(), placed.end(), placed_.begin(), placed_.end(),
                                  [](const Placed& a, const Placed& b) { return same(a, b); });
    if (known) return composition_;
  }
  const cv::Mat composition = compose();
  const std::lock_guard<std::mutex> lock(mutex_);
  placed_ = placed;
  composition_ = composition;
  return composition;
}

}  // namespace mbncc::sim
