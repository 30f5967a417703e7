// SPDX-License-Identifier: BSD-3-Clause
// Bias of a pose caused by light that does not rotate with the object.
#pragma once

#include <opencv2/core.hpp>

#include "matching/template/surface_template.hpp"

namespace mbncc::refinement {

/// Light displaces the pose by a part of the visible shading, and this error does not average out.
/// Fitted to drawn scenes under a lamp, in diffuse light and in even light.
class IlluminationBias {
 public:
  IlluminationBias() = default;

  /// For a surface in an image with `contrast` relative to the template.
  IlluminationBias(const templates::SurfaceTemplate& surface, const templates::SurfaceSample& seen,
                   double contrast);

  double of_brightness() const;  ///< [px] standard deviation from the brightness alone
  double of_contour() const;     ///< [px] standard deviation from the contour alone

  /// Covariance of the whole pose (x, y, theta) [px^2, rad^2] for an object of `radius` [px].
  cv::Matx33d of_pose(double radius) const;

 private:
  double shading_ = 0;  // [px^2] variance of the displacement by a difference in shading
};

}  // namespace mbncc::refinement
