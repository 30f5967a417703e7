// Evidence for and against an object at a pose, and its fusion into one score. Correlation alone
// cannot tell: under a lamp, shading and gloss do not turn with the object.
#pragma once

#include <algorithm>

#include "matching/contour_template.hpp"
#include "matching/rendering.hpp"
#include "matching/surface_template.hpp"

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
  double visible = 0;           ///< [0..1] part of the surface points inside the picture
};

/// Surface and contour of one view at one pyramid level.
struct PoseTemplate {
  SurfaceTemplate surface;
  ContourTemplate contour;

  /// [px at level] no point lies farther from the anchor.
  double reach() const { return std::max(surface.radius(), contour.radius()); }
};

Evidence gather_evidence(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose);

/// Fused log-odds that the object of `area` [px] lies at the pose: a logistic model of the
/// evidence. Small objects are matched by chance more often and need more.
double log_odds(const Evidence& evidence, double area);

/// Log-odds that all pixels of a small object of `area` [px], `rendered` at the pose that
/// `evidence` was read at, add to it.
double rendering_odds(const Evidence& evidence, const Rendered& rendered, double area);

/// Log-odds, up to a constant, of one rotation against others at the same place. Shading and gloss
/// do not turn with the object, so only what they leave alone counts.
double rotation_odds(const Evidence& evidence);

/// A pose reached by climbing.
struct Climbed {
  Pose2D pose;
  double value = 0;  ///< [-2..2] contour agreement plus correlation without shading
};

/// Gauss-Newton ascent of contour agreement plus correlation without shading, from `start` [px at
/// the templates' level], at most `iterations` steps. Returns the best pose met, `start` itself
/// where nothing is better.
Climbed climb(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
              int iterations);

/// Ascent of the contour agreement alone, `iterations` steps; `value` is that agreement.
Climbed follow_contour(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
                       int iterations);

/// Like climb() with the contour counting little: a learned map may be a pixel off, and shadows
/// displace edges, so the surface knows better.
Climbed settle(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
               int iterations);

}  // namespace mbncc
