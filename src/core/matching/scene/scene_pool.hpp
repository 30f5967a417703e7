// SPDX-License-Identifier: BSD-3-Clause
// Pool of memory for searched images.
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "matching/scene/scene_image.hpp"

namespace mbncc::scene {

/// New memory from the system would cost a fifth of a search. Thread-safe; the pool must outlive
/// its scenes.
class ScenePool {
 public:
  /// `image` in the memory of an unused one, if there is any. See
  /// SceneImage::show().
  std::shared_ptr<const SceneImage> show(const cv::Mat& image, int top_level);

 private:
  std::list<SceneImage>::iterator lend();

  std::mutex changing_;
  std::list<SceneImage> idle_, lent_;
};

}  // namespace mbncc::scene
