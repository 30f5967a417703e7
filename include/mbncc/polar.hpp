// SPDX-License-Identifier: BSD-3-Clause
// Polar images (the paper, doi 10.1177/1687814017728839): a disc in polar coordinates, where a
// rotation of the disc is a shift of columns.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc {

/// How a disc is sampled.
struct PolarGrid {
  double radius = 0;  ///< [px]
  int rings = 0;      ///< rows: ring i has radius (i + 0.5) radius / rings
  int angles = 0;     ///< columns: column j has angle 2 pi j / angles, from x towards y

  /// Grid with steps of at most one pixel; the number of angles is a multiple of 16.
  static PolarGrid of(double radius);

  double ring_radius(int ring) const { return (ring + 0.5) * radius / rings; }
};

/// A disc in polar form: row = ring, column = angle.
struct PolarImage {
  PolarGrid grid;
  cv::Mat values;  ///< CV_32FC1, grid.rings x grid.angles
};

/// The disc of `image` (CV_8UC1 or CV_32FC1) around `centre` [px], interpolated. The image's
/// border is replicated.
PolarImage polar_image(const cv::Mat& image, cv::Point2d centre, const PolarGrid& grid);

/// A template in polar form with its weights: inside the region, the radius of the ring, because
/// outer rings cover more area; 0 outside.
class PolarTemplate {
 public:
  /// `image` as in polar_image(); `region` is CV_8UC1 of the same size and non-zero for the pixels
  /// that are correlated. Samples that touch a pixel outside the region have no weight.
  PolarTemplate(const cv::Mat& image, const cv::Mat& region, cv::Point2d centre,
                const PolarGrid& grid);

  const PolarGrid& grid() const { return grid_; }

  /// Normalized cross-correlation [-1..1] with `target` (same grid) shifted by `first` .. `first` +
  /// `count` - 1 columns: entry k is high if the target shows the template rotated by 2 pi (first +
  /// k) / angles from x towards y.
  std::vector<double> similarities(const PolarImage& target, int first, int count) const;

  /// The same for all rotations.
  std::vector<double> similarities(const PolarImage& target) const {
    return similarities(target, 0, grid_.angles);
  }

 private:
  PolarGrid grid_;
  std::vector<float> weights_, weighted_;  // w and w (T - mean), ring by ring
  std::vector<char> used_;                 // whether a ring has weight
  double total_weight_ = 0, energy_ = 0;   // sum w, sum w (T - mean)^2
};

}  // namespace mbncc
