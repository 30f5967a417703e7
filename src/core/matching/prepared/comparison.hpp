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
  const PreparedObject* object;  ///< valid while the given object lives
  std::shared_ptr<const scene::SceneImage> scene;
};

/// One comparison per object, in the same order. Objects compared with the same image share a
/// scene. `grey`: whether the image has no colour. `scenes` must outlive the comparisons.
std::vector<Comparison> comparisons(
    const std::vector<std::shared_ptr<const PreparedObject>>& objects, const cv::Mat& image,
    bool grey, scene::ScenePool& scenes);

}  // namespace mbncc::prepared
