// Parts of an object that a picture does not show: covered, in gloss, clipped.
#pragma once

#include <vector>

#include "matching/contour_template.hpp"
#include "matching/surface_template.hpp"

namespace mbncc {

class HiddenParts {
 public:
  /// None is told.
  HiddenParts() = default;

  HiddenParts(const SurfaceTemplate& surface, const ContourTemplate& contour);

  /// Takes the compact parts of the surface whose `residuals`, see block_residuals(), are far
  /// larger than most out of what was read, with the contour beside them, as if they lay outside
  /// the picture. Returns their share [0..1] of the points; 0, and nothing changed, where there is
  /// none or too little else.
  double take_out(const std::vector<double>& residuals, SurfaceSample& surface,
                  ContourSample& contour) const;

 private:
  std::vector<int> block_ends_;        // see SurfaceTemplate
  std::vector<int> block_of_contour_;  // by contour point the nearest part of the surface
};

}  // namespace mbncc
