// SPDX-License-Identifier: BSD-3-Clause
// Mixing of object and background in the pixels along a map's edge (alpha matte), caused by the
// blur of lens, pixels and smoothing.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/map_geometry.hpp"

namespace mbncc::templates {

/// Mixture of a pixel on the map.
struct EdgeMixing {
  float share = 1;                      ///< [0..1] of the object; the rest is background
  std::array<cv::Point2f, 2> beyond{};  ///< [px] nearest background, on two sides if both are near
};

/// The mixtures of a map's pixels in a picture at a pyramid level.
class AlphaMatte {
 public:
  AlphaMatte(const MapGeometry& map, int level);

  /// `pixel` [px, level 0] lies on the map or in the room around it. Without background near, the
  /// share is 1.
  EdgeMixing at(cv::Point pixel) const;

  int room() const { return room_; }  ///< [px, level 0] the blur reaches beyond the map

 private:
  int side_, room_;
  cv::Mat share_;  // CV_32FC1, with `room_` pixels around the map
};

}  // namespace mbncc::templates
