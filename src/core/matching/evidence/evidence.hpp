// SPDX-License-Identifier: BSD-3-Clause
// Features of an object at a pose, and their fusion into one score. Correlation alone is not
// sufficient, because under a lamp shading and gloss do not rotate with the object.
#pragma once

#include "matching/template/pose_sample.hpp"

namespace mbncc::evidence {

/// Residual if nothing can be compared.
constexpr double kNoFit = 5;

/// A new member also belongs in log_odds(), in the explanation (explanation/explanation.cpp) and in
/// bench/fit, which fits the weights.
struct Evidence {
  double contour_score = -1;    ///< [-1..1] edges along the map's edge, see contour_agreement()
  double contour_coverage = 0;  ///< [0..1] part of the contour with a clear edge along it
  double gradient = 0;          ///< [-1..1] agreement of texture gradients inside the map
  /// ln(rms colour difference [grey levels] + 3) after gain and offset, over the best 5 of 8
  /// blocks, robust to occlusion.
  double trimmed_residual = kNoFit;
  double histogram = 0;          ///< [0..1] intersection of the chroma histograms
  double shading_free_ncc = 0;   ///< [-1..1] correlation of colour without shading and gloss
  double log_residual = kNoFit;  ///< ln(rms colour difference [grey levels] + 2) after a gain and
                                 ///< without shading and gloss
  double texture = 0;            ///< [0..1] of the object
  double cast = 0;               ///< size of the ColourCast removed from the colours; 0: none
  double compared = 0;           ///< [0..1] part of the surface points that are compared: inside
                                 ///< the image, and no highlights
};

/// Evidence for the object at `pose`, `scale` times as large as the template.
Evidence gather_evidence(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                         const Pose2D& pose, double scale = 1);

/// The same from the data already read at the pose.
Evidence gather_evidence(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                         const Pose2D& pose, const templates::PoseSample& sample, double scale = 1);

/// Fused log-odds that the object of `area` [px] lies at the pose: a logistic model of the
/// evidence. Small objects are matched by chance more often and need more evidence.
double log_odds(const Evidence& evidence, double area);

/// Log-odds, up to a constant, of one rotation against others at the same place. Shading and gloss
/// do not rotate with the object, so only features independent of them are used.
double rotation_odds(const Evidence& evidence);

}  // namespace mbncc::evidence
