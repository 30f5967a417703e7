// SPDX-License-Identifier: BSD-3-Clause
// Caches the drawings of a scene.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/sim/scene_content.hpp"
#include "sim/drawing.hpp"

namespace mbncc::sim {

/// This class is thread-safe.
class SceneCache {
 public:
  /// The object's drawing; it is drawn on first use.
  std::shared_ptr<const Drawing> drawing(const SceneObject& object);

  /// The platform with `placed` on it, computed by `compose` unless `placed` is the same as last
  /// time. The result must not be modified.
  cv::Mat composition(const std::vector<Placed>& placed, const std::function<cv::Mat()>& compose);

 private:
  struct Entry {
    SceneObject object;
    std::shared_ptr<const Drawing> drawing;
  };
  std::mutex mutex_;
  std::vector<Entry> drawings_;  // oldest first
  std::vector<Placed> placed_;   // what composition_ shows
  cv::Mat composition_;
};

}  // namespace mbncc::sim
