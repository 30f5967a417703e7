// SPDX-License-Identifier: BSD-3-Clause
// The last fraction of a pixel and of a degree, the scale, and how sure they are.
#pragma once

#include <opencv2/core.hpp>

#include "matching/evidence/evidence.hpp"
#include "matching/refinement/colour_axes.hpp"
#include "matching/refinement/contour_motion.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// An object at full resolution.
struct RefinementTemplate {
  RefinementTemplate() = default;
  /// `picture` is the one that the surface was made from.
  RefinementTemplate(PoseTemplate made, const SceneLevel& picture);

  PoseTemplate object;
  ColourAxes axes;
  ContourMotion contour_motion;
};

struct Refined {
  Pose2D pose;
  double scale = 1;        ///< of the object, against the template
  cv::Matx33d covariance;  ///< of x, y, theta [px^2, px rad, rad^2]
  cv::Matx33d cautious;    ///< the same where halves of the object lie apart: what parts them
                           ///< displaces the whole, too
};

/// The pose as it is, of which nothing is known: 100 px, a turn.
Refined unknown_accuracy(const Pose2D& pose);

/// Least squares from `start` [px, level 0], a pixel off at most, in up to `iterations` steps (0:
/// the covariance alone) over what the surface shows along its colour axes and over its contour.
/// Light displaces them, each by an amount of its own, and relief its brightness: they count as
/// loose along x and y, by as much. The scale is 1 unless another is seen beyond doubt.
Refined refine(const RefinementTemplate& object, const SceneLevel& scene, const Pose2D& start,
               int iterations);

}  // namespace mbncc
