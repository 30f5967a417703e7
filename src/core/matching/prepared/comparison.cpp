// SPDX-License-Identifier: BSD-3-Clause
#include "matching/prepared/comparison.hpp"

#include <algorithm>

#include "matching/scene/grey_image.hpp"

namespace mbncc::prepared {

std::vector<Comparison> comparisons(
    const std::vector<std::shared_ptr<const PreparedObject>>& objects, const cv::Mat& image,
    bool grey, scene::ScenePool& scenes) {
  std::vector<Comparison> all;
  int top = 0;
  for (const auto& object : objects) {
    all.push_back({grey && object->coloured ? object->in_grey->get() : object.get(), nullptr});
    top = std::max(top, all.back().object->top_level());
  }
  std::shared_ptr<const scene::SceneImage> colour_scene, grey_scene;
  for (auto& [object, scene] : all) {
    auto& shared = object->coloured ? colour_scene : grey_scene;
    if (!shared) shared = scenes.prepare(object->coloured ? image : scene::grey_image(image), top);
    scene = shared;
  }
  return all;
}

}  // namespace mbncc::prepared
