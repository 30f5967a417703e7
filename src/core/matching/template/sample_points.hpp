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

struct SamplePoints {
  std::vector<SurfacePoint> points;
  /// End in `points` of each block: compact parts of equal size, at most 8.
  std::vector<int> block_ends;
};

/// At most `most` points of a map of `size`, spread evenly: away from the edge, where image
/// pixels mix with the background; everywhere on a narrow map.
SamplePoints choose_surface_points(const MapGeometry& map, cv::Size size, int level,
                                   std::size_t most);

}  // namespace mbncc::templates
