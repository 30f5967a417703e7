// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_pool.hpp"

namespace mbncc::scene {

std::shared_ptr<const SceneImage> ScenePool::prepare(const cv::Mat& image, int top_level) {
  const auto place = lend();
  const std::shared_ptr<SceneImage> scene(&*place, [this, place](SceneImage* released) {
    released->forget();
    const std::lock_guard<std::mutex> lock(changing_);
    idle_.splice(idle_.begin(), lent_, place);
  });
  scene->set_image(image, top_level);
  return scene;
}

std::list<SceneImage>::iterator ScenePool::lend() {
  const std::lock_guard<std::mutex> lock(changing_);
  if (idle_.empty()) idle_.emplace_back();
  lent_.splice(lent_.begin(), idle_, idle_.begin());
  return lent_.begin();
}

}  // namespace mbncc::scene
