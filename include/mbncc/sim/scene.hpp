// A seeded simulated cell whose truth is known: a textured platform, textured irregular objects at
// sub-pixel poses, light, noise and an arm. Serves demo, tests and benchmarks; the same seed gives
// the same pictures.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::sim {

/// A flat textured object with an irregular outline.
struct SceneObject {
  std::uint64_t seed = 1;   ///< draws outline and texture
  double diameter = 90;     ///< [px]
  double elongation = 1.6;  ///< [1] longest by shortest extent
};

/// An object lying at a pose: position of its map's centroid, angle against its own drawing.
struct Placed {
  SceneObject object;
  Pose2D pose;
};

struct SceneConfig {
  cv::Size size{640, 480};      ///< [px]
  std::uint64_t seed = 1;       ///< platform texture
  double noise_sigma = 2;       ///< [grey levels]
  double light_gradient = 0.1;  ///< [0..1] fall-off of the light across the picture
  double gain = 1;              ///< exposure
};

/// Renders pictures of the cell.
class Scene {
 public:
  explicit Scene(SceneConfig config = {});

  const SceneConfig& config() const { return config_; }

  /// CV_8UC3 picture of the platform with `placed` on it, later ones on top. `frame` seeds the
  /// noise. `arm` (when not empty) is the polygon [px] of an arm-like occluder drawn on top.
  cv::Mat render(const std::vector<Placed>& placed, std::uint64_t frame = 0,
                 const std::vector<cv::Point2f>& arm = {}) const;

  /// True map (CV_8UC1, 0/255, pixel coverage >= 0.5) of one placed object.
  cv::Mat true_map(const Placed& placed) const;

 private:
  SceneConfig config_;
  cv::Mat platform_;  // CV_32FC3
};

}  // namespace mbncc::sim
