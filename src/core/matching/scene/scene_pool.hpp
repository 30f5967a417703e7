// SPDX-License-Identifier: BSD-3-Clause
// Pool of memory for searched images.
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "matching/scene/scene_image.hpp"

namespace mbncc::scene {

/// Reuses the memory of scenes, because new memory from the system would take a fifth of a search's
/// time. Thread-safe; the pool must outlive its scenes.
class ScenePool {
 public:
  /// A scene of `image`, in the memory of an unused scene if there is any. See
  /// SceneImage::set_image().
  std::shared_ptr<const SceneImage> prepare(const cv::Mat& image, int top_level);

 private:
  std::list<SceneImage>::iterator lend();

  std::mutex changing_;
  std::list<SceneImage> idle_, lent_;
};

}  // namespace mbncc::scene
