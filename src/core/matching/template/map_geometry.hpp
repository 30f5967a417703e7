// SPDX-License-Identifier: BSD-3-Clause
// Position of a map's pixels relative to its edge.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::templates {

/// A point of the map's edge.
struct EdgePoint {
  cv::Point2f position;  ///< [px] between the last map pixel and the first beyond
  cv::Point2f normal;    ///< unit, pointing out of the map
};

class MapGeometry {
 public:
  explicit MapGeometry(const cv::Mat& map);

  /// Distance [px] of a pixel to the nearest one outside the map; 0 outside.
  float depth(cv::Point pixel) const { return depth_.at<float>(pixel); }

  /// Unit vector from a map pixel away from the nearest edge.
  cv::Point2f inward(cv::Point pixel) const;

  /// Mean width [px]: that of a long strip with this area and edge length.
  double mean_width() const { return mean_width_; }

  /// All points of the edge, holes included, in order along each contour. `smoothing` [px] is that
  /// of the normals.
  std::vector<EdgePoint> edge(double smoothing) const;

 private:
  cv::Mat map_, depth_, slope_x_, slope_y_;
  double mean_width_ = 0;
};

/// `image` (CV_8UC3) with the surface under `map` extrapolated outwards, so that smoothing does
/// not mix background into the object.
cv::Mat continued_outwards(const cv::Mat& image, const cv::Mat& map);

}  // namespace mbncc::templates
