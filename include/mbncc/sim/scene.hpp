// SPDX-License-Identifier: BSD-3-Clause
// A simulated cell with known truth, reproducible from a seed: a textured platform, textured
// irregular objects at sub-pixel poses, light, noise and an arm. Used by the demo, the tests and
// the benchmarks; the same seed gives the same images.
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/sim/scene_content.hpp"

namespace mbncc::sim {

struct SceneConfig {
  cv::Size size{640, 480};      ///< [px]
  std::uint64_t seed = 1;       ///< platform texture, light direction and noise
  double noise_sigma = 2;       ///< [grey levels] at medium brightness; grows with the signal
  double light_gradient = 0.1;  ///< [0..1] fall-off of the light across the image
  double gain = 1;              ///< exposure
  double blur_sigma = 0.6;      ///< [px] of the optics
};

class SceneCache;

/// Renders images of the cell. The const functions may run in several threads.
class Scene {
 public:
  explicit Scene(SceneConfig config = {});

  const SceneConfig& config() const { return config_; }

  /// CV_8UC3 image of the platform with `placed` on it, later ones on top, and the arm above
  /// everything. `frame` seeds the noise.
  cv::Mat render(const std::vector<Placed>& placed, std::uint64_t frame = 0,
                 const std::optional<Arm>& arm = std::nullopt) const;

  /// True map (CV_8UC1, 0/255, pixel coverage >= 0.5) of one placed object.
  cv::Mat true_map(const Placed& placed) const;

 private:
  cv::Mat compose_at_rest(const std::vector<Placed>& placed) const;

  SceneConfig config_;
  cv::Mat platform_;                   // CV_32FC3 [grey levels]
  cv::Mat light_;                      // CV_32FC3 [1]
  std::shared_ptr<SceneCache> cache_;  // cache of drawings, shared by all copies
};

}  // namespace mbncc::sim
