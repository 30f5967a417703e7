// SPDX-License-Identifier: BSD-3-Clause
// Aligns one outline with another by iterated closest points: Besl and McKay, A method for
// registration of 3-D shapes, IEEE PAMI 14(2), 1992; with distances along the normals as in Chen
// and Medioni, Object modelling by registration of multiple range images, Image and Vision
// Computing 10(3), 1992.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>

#include "matching/template/contour_template.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

struct RegisteredContour {
  Pose2D pose;     ///< of the moved contour, relative to the fixed one
  double covered;  ///< [0..1] part of the moved contour that lies on the fixed one
};

class ClosestPoints {
 public:
  /// `fixed` must outlive this object.
  explicit ClosestPoints(const templates::ContourTemplate& fixed);

  /// Iterates from `start` to a local optimum. Returns the visited pose at which most of `moved`, a
  /// contour of about the same size, lies on the fixed contour.
  RegisteredContour align(const templates::ContourTemplate& moved, const Pose2D& start) const;

 private:
  struct Step;

  std::size_t nearest(cv::Point2d place) const;
  Step step_at(const templates::ContourTemplate& moved, const Pose2D& pose, double farthest) const;

  const templates::ContourTemplate& fixed_;
  double cell_;      // [px] side of a grid cell
  int half_;         // [cells] from the anchor, in the middle, to the edge of the grid
  cv::Mat nearest_;  // CV_32S: for each cell, the index of the nearest contour point
};

}  // namespace mbncc::evidence
