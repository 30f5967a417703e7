// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/outline_alternatives.hpp"

#include "matching/decision/detection.hpp"
#include "matching/evidence/contour_alternative.hpp"
#include "matching/evidence/evidence.hpp"
#include "matching/evidence/torn_contour.hpp"
#include "matching/scene/torn_rows.hpp"

namespace mbncc::search {
namespace {

double log_odds(const ViewInImage& found, const templates::PoseTemplate& object,
                const Pose2D& pose) {
  return evidence::log_odds(evidence::gather_evidence(object, found.level(), pose, found.scale),
                            found.view.shape.area());
}

/// Whether the log-odds of `alternative`, of outline and surface together, are not comparable to
/// those of the found pose, although its outline fits better.
bool is_contradicted(const ViewInImage& found, const templates::PoseTemplate& alternative,
                     const Pose2D& pose) {
  return log_odds(found, found.view.fine, found.pose) - log_odds(found, alternative, pose) >
         decision::kComparable;
}

}  // namespace

double mirrored_advantage(const ViewInImage& found) {
  const templates::PoseTemplate& object = found.view.fine;
  if (found.view.symmetry == 0) return 0;
  const auto other = found.view.mirrored_contour.alternative(object.contour, found.level(),
                                                             found.pose, found.scale);
  if (other.advantage <= 0) return other.advantage;
  templates::PoseTemplate mirrored = object;
  mirrored.mirror();
  return is_contradicted(found, mirrored, other.pose) ? 0 : other.advantage;
}

double nearby_advantage(const ViewInImage& found) {
  const templates::PoseTemplate& object = found.view.fine;
  const auto other =
      evidence::alternative_elsewhere(object.contour, found.level(), found.pose, found.scale);
  if (other.advantage <= 0) return other.advantage;
  return is_contradicted(found, object, other.pose) ? 0 : other.advantage;
}

bool is_torn(const ViewInImage& found) {
  const templates::ContourTemplate& contour = found.view.fine.contour;
  const cv::Rect box = templates::bounding_box(contour, found.pose, found.scale);
  return scene::has_torn_rows(found.scene.grey[0], box) ||
         evidence::advantage_torn(contour, found.level(), found.pose, found.scale) >
             evidence::kTorn;
}

}  // namespace mbncc::search
