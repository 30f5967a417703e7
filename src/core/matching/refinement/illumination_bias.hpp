// SPDX-License-Identifier: BSD-3-Clause
// What light that does not turn with an object does to where it is seen.
#pragma once

#include <opencv2/core.hpp>

#include "matching/template/surface_template.hpp"

namespace mbncc {

/// Light displaces what is seen by a part of what it is seen to change, and that error does not
/// average out. Fitted to drawn scenes under a lamp, in diffuse light and in even light.
class IlluminationBias {
 public:
  IlluminationBias() = default;

  /// Of a surface that is seen with `contrast`, the picture's by the template's.
  IlluminationBias(const SurfaceTemplate& surface, const SurfaceSample& seen, double contrast);

  double of_brightness() const;  ///< [px] deviation
  double of_contour() const;     ///< [px] likewise

  /// Of all together, of x, y, theta [px^2, rad^2], for an object of this radius [px].
  cv::Matx33d of_pose(double radius) const;

 private:
  double shading_ = 0;  // [px^2] variance of what shading unlike the lesson's would displace
};

}  // namespace mbncc
