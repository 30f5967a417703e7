// SPDX-License-Identifier: BSD-3-Clause
// Pool of memory for searched pictures.
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "matching/scene/scene_picture.hpp"

namespace mbncc::scene {

/// New memory from the system would cost a fifth of a search. Thread-safe; the pool must outlive
/// its scenes.
class ScenePool {
 public:
  /// `picture` in the memory of an unused one, if there is any. See
  /// ScenePicture::show().
  std::shared_ptr<const ScenePicture> show(const cv::Mat& picture, int top_level);

 private:
  std::list<ScenePicture>::iterator lend();

  std::mutex changing_;
  std::list<ScenePicture> idle_, lent_;
};

}  // namespace mbncc::scene
