// SPDX-License-Identifier: BSD-3-Clause
// Surface and contour of an image at a candidate pose.
#pragma once

#include <algorithm>

#include "matching/template/contour_template.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::templates {

/// Surface and contour of one view at one pyramid level.
struct PoseTemplate {
  SurfaceTemplate surface;
  ContourTemplate contour;

  /// [px at level] Largest distance of a point from the anchor.
  double reach() const { return std::max(surface.radius(), contour.radius()); }

  /// Mirrors surface and contour at the y axis; see their own mirror().
  void mirror() {
    surface.mirror();
    contour.mirror();
  }
};

struct PoseSample {
  SurfaceSample surface;
  ContourSample contour;
  SurfaceTemplate::Residual residual;  ///< of the surface, if enough is visible

  /// Reads the image at `pose`, the object `scale` times as large as the template, edges up to
  /// `reach` [px] along the contour's normals, see read_contour().
  void read(const PoseTemplate& object, const scene::SceneLevel& scene, const Pose2D& pose,
            int reach, double scale = 1);
};

}  // namespace mbncc::templates
