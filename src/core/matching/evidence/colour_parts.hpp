// SPDX-License-Identifier: BSD-3-Clause
// The parts of an object that have one colour each, and whether a picture shows them in it. Among
// tools, what tells look-alikes apart is the colour of one part, while all else agrees.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc {

/// Median colour (b, g, r) a little outside of the contour [scale times as large] at `pose`.
cv::Vec3f ground_beside(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                        double scale = 1);

/// [0..2] By how much the chroma (ln R/G, ln B/G) of the part that differs most is off from what
/// its lesson, in the light of the picture, would be.
struct ColourDifference {
  double colour = 0;  ///< of the parts of one colour each: little of what covers the object
  double block = 0;   ///< of compact parts: what covers one without hiding its outline as well
};

class ColourParts {
 public:
  ColourParts() = default;

  /// `ground` is the lesson's.
  ColourParts(const SurfaceTemplate& surface, const ContourTemplate& contour,
              const cv::Vec3f& ground);

  bool empty() const { return colour_.empty(); }

  /// Only points count beside which the contour is found: what covers the object covers its contour
  /// as well. What another `ground` explains by shining through does not count either: learned maps
  /// hold some of it.
  ColourDifference worst_differences(const SurfaceTemplate& surface, const SurfaceSample& sample,
                                     const ContourSample& contour, const cv::Vec3f& ground) const;

 private:
  std::vector<float> witnessed(const SurfaceSample& sample, const ContourSample& contour) const;

  cv::Vec3f ground_;                ///< of the lesson
  std::vector<int> colour_;         ///< of each point: the parts of one colour each
  std::vector<int> block_;          ///< of each point: compact parts
  std::vector<int> witnesses_;      ///< contour points beside the points, point after point
  std::vector<int> witnesses_end_;  ///< of each point, in `witnesses_`
};

}  // namespace mbncc
