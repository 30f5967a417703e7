// SPDX-License-Identifier: BSD-3-Clause
// Memory for pictures under search, used again from picture to picture.
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "matching/scene/scene_picture.hpp"

namespace mbncc {

/// Memory fresh from the system costs a fifth of a search. Several threads may ask at a time; the
/// pool must outlive what it shows.
class ScenePool {
 public:
  /// `picture` in memory of one that nobody looks at any more, if there is any. See
  /// ScenePicture::show().
  std::shared_ptr<const ScenePicture> show(const cv::Mat& picture, int top_level);

 private:
  std::list<ScenePicture>::iterator lend();

  std::mutex changing_;
  std::list<ScenePicture> idle_, lent_;
};

}  // namespace mbncc
