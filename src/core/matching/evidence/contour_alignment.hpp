// SPDX-License-Identifier: BSD-3-Clause
// Aligns an outline with the edges of an image.
#pragma once

#include <algorithm>

#include "matching/scene/scene_level.hpp"
#include "matching/template/candidate.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc::evidence {

struct AlignedContourPose {
  Pose2D pose;
  double agreement;  ///< see contour_agreement()
};

class ContourAlignment {
 public:
  /// The contour is `scale` times as large as the template. `pixels` must contain the surroundings
  /// of all poses.
  ContourAlignment(const templates::ContourTemplate& contour, const scene::PreparedPixels& pixels,
                   double scale = 1)
      : contour_(contour), pixels_(pixels), scale_(scale) {}

  /// contour_agreement() at `pose`.
  double at(const Pose2D& pose) {
    templates::read_contour(contour_, pixels_.edges, pose, 0, sample_, scale_);
    return templates::contour_agreement(contour_, sample_);
  }

  /// Hill climbing from `start` over `allowed` poses: at most `steps` steps of 1 px along x, y or,
  /// by rotation, the rim. Returns the best pose.
  template <class Allowed>
  AlignedContourPose aligned(const Pose2D& start, int steps, const Allowed& allowed) {
    AlignedContourPose best{start, at(start)};
    for (int k = 0; k < steps; ++k) {
      const auto [from, before] = best;
      for (const double step : {-1., 1.}) {
        const double turn = step / std::max(1.0, scale_ * contour_.radius());
        for (const Pose2D& next :
             {Pose2D{from.x + step, from.y, from.theta}, Pose2D{from.x, from.y + step, from.theta},
              Pose2D{from.x, from.y, from.theta + turn}}) {
          const double agreement = allowed(next) ? at(next) : -1;
          if (agreement > best.agreement) best = {next, agreement};
        }
      }
      if (best.agreement == before) break;
    }
    return best;
  }

  AlignedContourPose aligned(const Pose2D& start, int steps) {
    return aligned(start, steps, [](const Pose2D&) { return true; });
  }

 private:
  const templates::ContourTemplate& contour_;
  scene::PreparedPixels pixels_;
  double scale_;
  templates::ContourSample sample_;
};

/// Moves `candidate`, at the same rotation, to the place within 6 px along x and y [px at level]
/// where the contour agrees best with the edges. The agreement becomes its value.
templates::Candidate shifted_onto_edges(const templates::ContourTemplate& contour,
                                        const scene::SceneLevel& scene,
                                        const templates::Candidate& candidate);

}  // namespace mbncc::evidence
