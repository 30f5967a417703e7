// The map's edge as points with normals, compared with the edges of a picture.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/map_geometry.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

struct ContourTemplate {
  ContourTemplate() = default;

  /// At most `most` points evenly along the edge at pyramid level `level`, about `anchor` [px,
  /// level 0].
  ContourTemplate(const MapGeometry& map, cv::Point2d anchor, int level, std::size_t most);

  std::size_t size() const { return x.size(); }

  std::vector<float> x, y;                ///< [px at level] relative to the anchor
  std::vector<float> normal_x, normal_y;  ///< unit, outwards
};

/// Mean edge response [-1..1] along the contour at `pose`, each point taking the best within one
/// pixel along its normal; -1 where less than a quarter of the contour is visible. `edges` is an
/// edge_picture().
double contour_agreement(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose);

/// Normal equations of the small motion (dx, dy, dtheta) of the contour that brings it onto the
/// edges found within `reach` [px] along the normals. Motion and equations are in the template's
/// frame: where the template would have to be moved from to fit (the inverse of what the pose
/// needs).
struct ContourPull {
  cv::Matx33d hessian;  ///< curvature of contour_agreement()
  cv::Vec3d gradient;   ///< hessian * motion
};
ContourPull contour_pull(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose,
                         int reach);

}  // namespace mbncc
