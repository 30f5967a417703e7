// SPDX-License-Identifier: BSD-3-Clause
// Compares the colours of an object's parts with an image. Similar tools often differ only in the
// colour of one part.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {

class ColourParts {
 public:
  ColourParts() = default;

  /// `ground`: background_colour() in the lesson.
  ColourParts(const templates::SurfaceTemplate& surface, const templates::ContourTemplate& contour,
              const cv::Vec3f& ground);

  /// [0..2] Chroma difference (ln R/G, ln B/G) between image and lesson, in the light of the image,
  /// that parts with at least .045 of the surface's points reach together. Uses only points near a
  /// found contour, because an occluder hides the contour as well. Differences explained by another
  /// `ground` are subtracted, because learned maps contain some background.
  double worst_difference(const templates::SurfaceTemplate& surface,
                          const templates::SurfaceSample& sample,
                          const templates::ContourSample& contour, const cv::Vec3f& ground) const;

 private:
  std::vector<float> weights_from_contour(const templates::SurfaceSample& sample,
                                          const templates::ContourSample& contour) const;

  cv::Vec3f ground_;                      ///< background_colour() in the lesson
  std::vector<int> part_;                 ///< of each point: index of its part of uniform colour
  std::vector<std::vector<int>> beside_;  ///< of each point: indices of contour points beside it
};

}  // namespace mbncc::evidence
