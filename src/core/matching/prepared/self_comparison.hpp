// SPDX-License-Identifier: BSD-3-Clause
// Compares a view with itself after a rotation.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc::prepared {

/// A view's map on a square canvas of bounded size, its centroid in the middle.
class CentredMap {
 public:
  explicit CentredMap(const View& view);

  double radius() const { return radius_; }  ///< [px of the view] farthest map pixel
  double scale() const { return scale_; }    ///< [px of the canvas / px of the view]
  const cv::Mat& map() const { return map_; }
  double area() const { return static_cast<double>(points_.size()); }  ///< [px of the canvas]

  /// Transform from the canvas to the view, rotated by `angle` [rad] about the centroid and then
  /// moved by `shift` [px of the canvas].
  cv::Matx23d to_view(double angle, cv::Vec2d shift = {}) const;

  /// Part [0..1] of the map that the map covers after a rotation by `angle` [rad].
  double overlap(double angle) const;

 private:
  cv::Point2d centre_;  // [px of the view]
  double radius_ = 1, scale_ = 1;
  cv::Mat map_;
  std::vector<cv::Point> points_;
};

/// Differences after a rotation.
struct TurnDifference {
  double overlap = 0;  ///< [0..1] part of the map that the rotated map covers
  double outline = 0;  ///< [px of the view] depth to which the outlines differ
  double rest = 0;     ///< [grey levels] rms of the surface, without shading
  double mark = 0;     ///< [grey levels] strongest local one, without shading
};

/// Compares outline and surface after a rotation. The angle is not fitted, because a symmetry angle
/// is exact; the shift is the one that fits best.
class SelfComparison {
 public:
  /// `map` must be made from `view` and outlive this object.
  SelfComparison(const View& view, const CentredMap& map);

  /// The differences after a rotation by `angle` [rad].
  TurnDifference difference(double angle) const;

  double texture() const { return texture_; }  ///< [grey levels] rms of the surface
  double noise_of_mark() const;                ///< [grey levels] what noise adds to `mark`

 private:
  static constexpr int kPlanes = 4;  // coverage, blue, green, red
  using Planes = std::array<cv::Mat, kPlanes>;

  Planes sampled(double angle, cv::Vec2d shift) const;
  cv::Vec2d best_shift(double angle) const;
  void compare_outlines(const cv::Mat& turned_map, TurnDifference& difference) const;
  void compare_surfaces(const Planes& turned, const cv::Mat& turned_map,
                        TurnDifference& difference) const;
  void make_basis();
  void make_slopes();
  cv::Mat without_shading(const cv::Mat& values) const;

  const CentredMap& map_;
  cv::Mat source_;                // CV_32FC4 coverage and colours, smoothed
  Planes own_;                    // CV_32FC1, the view on the canvas
  cv::Mat inner_;                 // CV_8UC1, the map without its rim
  cv::Mat outside_, inside_;      // CV_32FC1 [px] distances to the map, to its background
  std::vector<cv::Mat> basis_;    // orthonormal smooth functions on inner_
  std::array<Planes, 2> slopes_;  // derivatives by x and y
  cv::Matx22d hessian_;
  Planes misaligned_;  // [grey levels] largest change by a small misalignment
  double texture_ = 0, noise_ = 0;
};

}  // namespace mbncc::prepared
