// SPDX-License-Identifier: BSD-3-Clause
// Evidence for and against an object at a pose, and its fusion into one score. Correlation alone
// cannot tell: under a lamp, shading and gloss do not turn with the object.
#pragma once

#include "matching/template/pose_sample.hpp"

namespace mbncc {

/// Residual where there is nothing to compare.
constexpr double kNoFit = 5;

struct Evidence {
  double contour = -1;          ///< [-1..1] edges along the map's edge, see contour_agreement()
  double found = 0;             ///< [0..1] part of the contour with a clear edge along it
  double gradient = 0;          ///< [-1..1] direction of texture gradients inside
  double best_blocks = kNoFit;  ///< ln(rms colour difference [grey levels] + 3) after gain and
                                ///< offset, over the best 5 of 8 blocks: bears occlusion and gloss
  double histogram = 0;         ///< [0..1] intersection of the chroma histograms
  double projected = 0;         ///< [-1..1] correlation of colour without shading and gloss
  double unexplained = kNoFit;  ///< ln(rms colour difference [grey levels] + 2) after a gain and
                                ///< without shading and gloss
  double texture = 0;           ///< [0..1] of the object: a plain one has little to agree with
  double cast = 0;     ///< size of the ColourCast that the colours were freed from; 0: as seen
  double visible = 0;  ///< [0..1] part of the surface points inside the picture
};

/// Of the object `scale` times as large as the template.
Evidence gather_evidence(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose,
                         double scale = 1);

/// From what has been read at the pose.
Evidence gather_evidence(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose,
                         const PoseSample& sample, double scale = 1);

/// Fused log-odds that the object of `area` [px] lies at the pose: a logistic model of the
/// evidence. Small objects are matched by chance more often and need more.
double log_odds(const Evidence& evidence, double area);

/// Log-odds, up to a constant, of one rotation against others at the same place. Shading and gloss
/// do not turn with the object, so only what they leave alone counts.
double rotation_odds(const Evidence& evidence);

/// The same, more surely, where the surface's `misfit` (PhotometricResidual) has been read, too.
double rotation_odds(const Evidence& evidence, double misfit);

}  // namespace mbncc
