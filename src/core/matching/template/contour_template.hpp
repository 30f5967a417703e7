// SPDX-License-Identifier: BSD-3-Clause
// The map's edge as points with normals, compared with the edges of an image.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/map_geometry.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::templates {

struct ContourTemplate {
  ContourTemplate() = default;

  /// At most `most` points evenly spaced along the map's `edge` at pyramid level `level`, about
  /// `anchor` [px, level 0].
  ContourTemplate(const std::vector<EdgePoint>& edge, cv::Point2d anchor, int level,
                  std::size_t most);

  /// Scales the points: the same contour `factor` times as large.
  void resize(double factor);

  /// Mirrors the points and normals at the y axis, to read the mirrored contour; `motion` and
  /// `products` remain those of the contour.
  void mirror();

  /// The map's edge, with normals smoothed like the pixels of a level.
  static std::vector<EdgePoint> edge_of(const MapGeometry& map, int level);

  std::size_t size() const { return count_; }
  double radius() const { return radius_; }  ///< [px at level] of the farthest point

  // All padded to whole lanes with points outside every image.
  std::vector<float> x, y;                ///< [px at level] relative to the anchor
  std::vector<float> normal_x, normal_y;  ///< unit, outwards
  std::vector<float> ones;                ///< 1 at points, 0 in the padding

  /// Jacobian of each point's distance from its edge with respect to the motion (dx, dy, dtheta): 3
  /// rows, and their pairwise products (xx, xy, yy, xt, yt, tt): 6 rows.
  std::vector<float> motion, products;

 private:
  std::size_t count_ = 0;
  double radius_ = 0;
};

/// Readings of the edges near a contour; see kernels::NormalReadings.
struct ContourSample {
  std::vector<float> response, seen, pull, moment;  ///< as long as the contour's vectors
};

/// Reads `edges`, see smooth_and_find_edges(), at `pose`, up to `reach` [px] along the normals, the
/// contour `scale` times (near 1) as large as the template. At reach 0, `pull` and `moment` are not
/// read.
void read_contour(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose,
                  int reach, ContourSample& sample, double scale = 1);

/// [px] The contour's box at `pose`, `scale` times as large.
cv::Rect bounding_box(const ContourTemplate& contour, const Pose2D& pose, double scale);

/// Mean edge response [-1..1] along the contour, each point taking the best within one pixel along
/// its normal; -1 where less than a quarter of the contour is visible.
double contour_agreement(const ContourTemplate& contour, const ContourSample& sample);

/// Whether a response is that of a clear edge along the contour.
inline bool is_clear(float response) {
  constexpr float kClear = 0.4f;
  return response > kClear;
}

/// Indices of the contour's points that are about as near to `at` [px at level, relative to the
/// anchor] as the nearest one. An occluder of `at` mostly hides them, too.
std::vector<int> points_beside(const ContourTemplate& contour, cv::Point2f at);

/// Part [0..1] of the visible contour where there is a clear edge along it.
double contour_found(const ContourTemplate& contour, const ContourSample& sample);

/// The same of the contour beside `at` [px] relative to the anchor, see points_beside(); 0 if it is
/// not visible there.
double contour_found_beside(const ContourTemplate& contour, const ContourSample& sample,
                            cv::Point2f at);

/// Normal equations of the small motion (dx, dy, dtheta) of the contour that aligns it with the
/// found edges. Motion and equations are in the template's frame (the inverse of the pose's
/// motion).
struct ContourPull {
  cv::Matx33d hessian;  ///< curvature of contour_agreement()
  cv::Vec3d gradient;   ///< hessian * motion
};
ContourPull contour_pull(const ContourTemplate& contour, const ContourSample& sample);

}  // namespace mbncc::templates
