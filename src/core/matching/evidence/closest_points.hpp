// SPDX-License-Identifier: BSD-3-Clause
// Lays one outline upon another by iterated closest points: Besl, McKay, A method for registration
// of 3-D shapes, IEEE PAMI 14(2), 1992, with distances along the normals.
#pragma once

#include <opencv2/core.hpp>

#include "matching/template/contour_template.hpp"

namespace mbncc::evidence {

struct LaidContour {
  Pose2D pose;     ///< of the moved contour, relative to the fixed one
  double covered;  ///< [-1..1] part of the moved contour that lies on the fixed one
};

class ClosestPoints {
 public:
  /// `fixed` must outlive it.
  explicit ClosestPoints(const templates::ContourTemplate& fixed);

  /// The pose reached from `start` at which most of `moved`, a contour of about the same size,
  /// covers the fixed one.
  LaidContour lay(const templates::ContourTemplate& moved, const Pose2D& start) const;

 private:
  struct Step;

  std::size_t nearest(cv::Point2d place) const;
  Step step_at(const templates::ContourTemplate& moved, const Pose2D& pose) const;

  const templates::ContourTemplate& fixed_;
  int half_;      // [px] of the grid, about the anchor
  cv::Mat grid_;  // CV_32S, index of the point nearest to each pixel
};

}  // namespace mbncc::evidence
