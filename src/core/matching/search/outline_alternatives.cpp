// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/outline_alternatives.hpp"

#include <algorithm>

#include "matching/decision/detection.hpp"
#include "matching/evidence/evidence.hpp"
#include "matching/evidence/torn_contour.hpp"
#include "matching/scene/torn_rows.hpp"

namespace mbncc::search {
namespace {

double odds_at(const ViewInImage& found, const templates::PoseTemplate& object,
               const Pose2D& pose) {
  return evidence::log_odds(evidence::gather_evidence(object, found.level(), pose, found.scale),
                            found.view.shape.area());
}

/// Whether the log-odds of the mirrored object at `pose`, of outline and surface together, are
/// comparable to those of the found pose.
bool is_comparable(const ViewInImage& found, const Pose2D& pose) {
  const templates::PoseTemplate& object = found.view.fine;
  templates::PoseTemplate mirrored = object;
  mirrored.mirror();
  return !(odds_at(found, object, found.pose) - odds_at(found, mirrored, pose) >
           decision::kComparable);
}

}  // namespace

double mirrored_advantage(const ViewInImage& found) {
  const evidence::MirroredContour& mirrored = found.view.mirrored_contour;
  if (found.view.symmetry == 0) return 0;
  double largest = 0;
  for (const auto& other :
       mirrored.alternatives(found.view.fine.contour, found.level(), found.pose, found.scale))
    if (other.advantage > std::max(largest, mirrored.limit()) && is_comparable(found, other.pose))
      largest = other.advantage;
  return largest;
}

bool is_torn(const ViewInImage& found) {
  const templates::ContourTemplate& contour = found.view.fine.contour;
  const cv::Rect box = templates::bounding_box(contour, found.pose, found.scale);
  return scene::has_torn_rows(found.scene.grey[0], box) ||
         evidence::advantage_torn(contour, found.level(), found.pose, found.scale) >
             evidence::kTorn;
}

}  // namespace mbncc::search
