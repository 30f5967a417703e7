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

/// Median colour (b, g, r) slightly outside the contour [scale times as large] at `pose`.
cv::Vec3f ground_beside(const templates::ContourTemplate& contour, const scene::SceneLevel& scene,
                        const Pose2D& pose, double scale = 1);

/// [0..2] Chroma difference (ln R/G, ln B/G) of the most different part to its lesson in the light
/// of the image.
struct ColourDifference {
  double colour = 0;  ///< of the parts of one colour each: less sensitive to occlusion
  double block = 0;   ///< of compact parts: also sensitive to occlusion inside the outline
};

class ColourParts {
 public:
  ColourParts() = default;

  /// `ground` is the lesson's.
  ColourParts(const templates::SurfaceTemplate& surface, const templates::ContourTemplate& contour,
              const cv::Vec3f& ground);

  bool empty() const { return colour_.empty(); }

  /// Uses only points near a found contour, because an occluder hides the contour as well.
  /// Differences explained by another `ground` that shines through are subtracted, because learned
  /// maps contain some background.
  ColourDifference worst_differences(const templates::SurfaceTemplate& surface,
                                     const templates::SurfaceSample& sample,
                                     const templates::ContourSample& contour,
                                     const cv::Vec3f& ground) const;

 private:
  std::vector<float> witnessed(const templates::SurfaceSample& sample,
                               const templates::ContourSample& contour) const;

  cv::Vec3f ground_;                ///< of the lesson
  std::vector<int> colour_;         ///< of each point: the parts of one colour each
  std::vector<int> block_;          ///< of each point: compact parts
  std::vector<int> witnesses_;      ///< contour points beside the points, point after point
  std::vector<int> witnesses_end_;  ///< of each point, in `witnesses_`
};

}  // namespace mbncc::evidence
