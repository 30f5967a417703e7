// SPDX-License-Identifier: BSD-3-Clause
// Caches the drawings of a scene.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/sim/scene.hpp"
#include "sim/drawing.hpp"

namespace mbncc::sim {

/// Thread-safe.
class SceneCache {
 public:
  /// The object's drawing, drawn at its first use.
  std::shared_ptr<const Drawing> drawing(const SceneObject& object);

  /// The platform with `placed` on it as `compose` makes it, unless it is the same as last time.
  /// Not to be written to.
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
