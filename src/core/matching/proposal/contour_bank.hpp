// SPDX-License-Identifier: BSD-3-Clause
// Template bank of an object's outline: points with directions, at all rotations.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/map_geometry.hpp"

namespace mbncc::proposal {

/// The contour at all rotations at one pyramid level.
class ContourBank {
 public:
  /// `anchor` [px, level 0]; the level is chosen by the contour's size.
  ContourBank(const templates::MapGeometry& map, cv::Point2d anchor);

  struct Point {
    int x, y;         ///< [px] relative to the anchor's pixel
    int orientation;  ///< of the normal, modulo a half turn
  };
  struct Rotation {
    double angle;  ///< [rad] in (-pi, pi]
    std::vector<Point> points;
  };

  int level() const { return level_; }
  int radius() const { return radius_; }  ///< [px at level]
  const std::vector<Rotation>& rotations() const { return rotations_; }

 private:
  int level_ = 0, radius_ = 0;
  std::vector<Rotation> rotations_;
};

}  // namespace mbncc::proposal
