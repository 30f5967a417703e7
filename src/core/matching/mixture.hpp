// How much of the background the pixels of a narrow object show. Lens, pixels and smoothing blur
// what is two pixels wide until it is half background; known shares are taken out again.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/map_geometry.hpp"
#include "matching/scene_level.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// What a pixel on the map shows.
struct Mixture {
  float share = 1;  ///< [0..1] of the object; the rest is background
  std::array<cv::Point2f, 2>
      beyond{};  ///< [px] the nearest background, on two sides if both are near
};

/// The mixtures of a map's pixels in a picture at a pyramid level.
class Coverage {
 public:
  Coverage(const MapGeometry& map, int level);

  /// `pixel` [px, level 0] lies on the map or in the room around it. Without background near, the
  /// share is 1.
  Mixture at(cv::Point pixel) const;

  int room() const { return room_; }  ///< [px, level 0] the blur reaches beyond the map

 private:
  int side_, room_;
  cv::Mat share_;  // CV_32FC1, with `room_` pixels around the map
};

/// The mixtures of a template's points.
class Unmixing {
 public:
  /// No mixtures.
  Unmixing() = default;

  /// `mixtures` hold places [px at level] in a picture, the template's `origin` likewise; there are
  /// as many as points, less padding to `padded`.
  Unmixing(const std::vector<Mixture>& mixtures, cv::Point2d origin, std::size_t padded);

  bool empty() const { return share_.empty(); }

  /// Moves the places apart, as the template's points.
  void resize(double factor);

  /// Takes the background, read beside the object at `pose`, out of the colours of the points that
  /// are `inside` (1, else 0). The object is `scale` times as large as the template.
  void apply(const SceneLevel& scene, const Pose2D& pose, double scale,
             const std::vector<float>& inside, std::array<std::vector<float>, 3>& planes) const;

 private:
  std::vector<float> share_;
  std::array<std::vector<float>, 2> x_, y_;  // [px at level] of the background
};

}  // namespace mbncc
