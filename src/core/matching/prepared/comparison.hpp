// SPDX-License-Identifier: BSD-3-Clause
// Pairs each object with the image that it is compared with.
#pragma once

#include <memory>
#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_pool.hpp"

namespace mbncc::prepared {

/// An object and an image as they are compared: in grey if either has no colour.
struct Comparison {
  const PreparedObject* object;  ///< lives as long as the given one
  std::shared_ptr<const scene::SceneImage> scene;
};

/// In the order of the objects; objects with the same comparison share a scene. The pool must
/// outlive them.
std::vector<Comparison> comparisons(
    const std::vector<std::shared_ptr<const PreparedObject>>& objects, const cv::Mat& image,
    scene::ScenePool& scenes);

}  // namespace mbncc::prepared
