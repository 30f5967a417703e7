// SPDX-License-Identifier: BSD-3-Clause
// Geometry of a view: its object frame, outline and area.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/map_footprint.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::templates {

/// A view in the frame of its anchor, the centre of the map's excircle.
struct ViewFrame {
  double scale = 1;            ///< of the view, relative to the lesson
  Pose2D reference_in_anchor;  ///< [px],[rad] object frame as seen from the anchor
  MapFootprint shape;          ///< area that the view covers
  int symmetry = 1;            ///< declared, otherwise measured
  /// [px] from the anchor: turning about it by a part of the symmetry leaves the object as it is.
  cv::Point2d symmetry_centre;
  std::vector<cv::Point2f> outline;  ///< [px] largest outline in the object frame
};

}  // namespace mbncc::templates
