// SPDX-License-Identifier: BSD-3-Clause
// Sample points of the object's surface.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/map_geometry.hpp"

namespace mbncc::templates {

struct SurfacePoint {
  cv::Point2f at;      ///< [px at level] in the template image
  float depth;         ///< [px at level 0] to the map's edge
  cv::Point2f inward;  ///< unit, away from the edge
};

/// Largest number of blocks: compact parts of equal size that a surface is split into.
constexpr std::size_t kMostBlocks = 8;

struct SamplePoints {
  std::vector<SurfacePoint> points;
  std::vector<int> block_ends;  ///< end of each block in `points`; at most kMostBlocks
};

/// At most `most` points of a map of `size`, spread evenly: away from the edge, where image
/// pixels mix with the background; everywhere on a narrow map.
SamplePoints choose_surface_points(const MapGeometry& map, cv::Size size, int level,
                                   std::size_t most);

}  // namespace mbncc::templates
