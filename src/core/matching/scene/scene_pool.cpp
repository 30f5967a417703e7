// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_pool.hpp"

namespace mbncc::scene {

std::shared_ptr<const ScenePicture> ScenePool::show(const cv::Mat& picture, int top_level) {
  const auto place = lend();
  const std::shared_ptr<ScenePicture> scene(&*place, [this, place](ScenePicture* shown) {
    shown->forget();
    const std::lock_guard<std::mutex> lock(changing_);
    idle_.splice(idle_.begin(), lent_, place);
  });
  scene->show(picture, top_level);
  return scene;
}

std::list<ScenePicture>::iterator ScenePool::lend() {
  const std::lock_guard<std::mutex> lock(changing_);
  if (idle_.empty()) idle_.emplace_back();
  lent_.splice(lent_.begin(), idle_, idle_.begin());
  return lent_.begin();
}

}  // namespace mbncc::scene
