// SPDX-License-Identifier: BSD-3-Clause
// The area that a map covers at a pose.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::templates {

class MapFootprint {
 public:
  /// `anchor` [px] is the origin of the shape's frame.
  MapFootprint(const cv::Mat& map, cv::Point2d anchor);

  double area() const { return area_; }      ///< [px]
  double radius() const { return radius_; }  ///< [px] farthest map pixel from the anchor

 private:
  friend double overlap(const MapFootprint&, const Pose2D&, const MapFootprint&, const Pose2D&);

  /// Whether the map covers a point of the shape's frame.
  bool covers(cv::Point2d point) const;

  cv::Mat map_;
  cv::Point2d anchor_;
  double area_ = 0, radius_ = 0;
  std::vector<cv::Point2d> sample_;  // evenly chosen pixels of the map, relative to the anchor
};

/// Common area of two maps as part of the smaller one [0..1].
double overlap(const MapFootprint& a, const Pose2D& pose_a, const MapFootprint& b,
               const Pose2D& pose_b);

}  // namespace mbncc::templates
