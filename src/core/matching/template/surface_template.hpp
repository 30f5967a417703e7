// SPDX-License-Identifier: BSD-3-Clause
// The object's surface as coloured points, prepared for comparison under changing light.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "imaging/chroma_histogram.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/map_geometry.hpp"
#include "matching/template/sample_points.hpp"
#include "matching/template/shading_basis.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::templates {

/// A highlight reaches kSaturated [grey levels] in all channels where the object, in the light of
/// the image, would be darker than kMaySaturate (sum of the channels).
constexpr float kSaturated = 240;
constexpr float kMaySaturate = 0.85F * 3 * kSaturated;

/// Colours of an image at the points of a surface: one plane per channel (b, g, r).
struct SurfaceSample {
  std::array<std::vector<float>, 3> planes;  ///< padded with zeros to whole lanes
  std::vector<float> inside;  ///< 1: compared; 0: outside the image, a highlight, or padding
  std::size_t visible = 0, points = 0;  ///< number of compared points, of all points

  /// Whether enough is visible for a comparison.
  bool suffices() const { return visible >= 10 && 4 * visible >= points; }
};

class SurfaceTemplate {
 public:
  static constexpr int kChannels = 3;

  SurfaceTemplate() = default;

  /// Input of a template at one pyramid level.
  struct Source {
    scene::PreparedPixels pixels;  ///< the learning image, the object extrapolated outwards
    const MapGeometry& map;
    cv::Size map_size;
    int level;
  };

  /// At most `most` points inside the map, spread evenly. `anchor` [px, level 0] is their origin.
  SurfaceTemplate(const Source& source, cv::Point2d anchor, std::size_t most);

  /// Scales the points: the same surface `factor` times as large.
  void resize(double factor);

  /// Mirrors the points and gradients at the y axis, to compare the mirrored surface; `slopes`
  /// remain those of the surface.
  void mirror();

  /// Derivatives of the colours with respect to x, y and theta at the points, per channel.
  static constexpr int kMotions = 3;
  using Slopes = std::array<std::array<std::vector<float>, kMotions>, kChannels>;
  /// Slopes in `image`, the one that the template was made from; 0 at its border.
  Slopes slopes_in(const scene::PreparedPixels& image) const;

  std::size_t size() const { return points_.size(); }
  std::size_t padded() const { return x.size(); }  ///< size() in whole lanes

  /// Reads the colours at `pose`, the surface `scale` times as large as the template. Points
  /// outside the image, and highlights, are not compared: they take the mean of the others.
  void sample(const scene::PreparedPixels& pixels, const Pose2D& pose, SurfaceSample& sample,
              double scale = 1) const;

  /// Residual of the colours after the basis is projected out of template and image.
  struct Residual {
    double common = 0;  ///< product of both, summed over points and channels [grey^2]
    double energy = 0;  ///< sum of squares of the image's residual [grey^2]
  };
  Residual residual(const SurfaceSample& sample) const;

  /// Correlation [-1..1] of the residuals of template and image.
  double correlation(const Residual& residual, double noise_variance) const;

  /// Mean square [grey^2] of the part of the image's residual that the template's, with a bounded
  /// gain, does not explain.
  double unexplained(const Residual& residual) const;

  /// Mean square [grey^2] of the difference between the image and `gain` times the template that
  /// the basis without its constant explains.
  double shading_difference(const SurfaceSample& sample, double gain) const;
  /// Gain of the image relative to the template, after the basis is projected out.
  double contrast(const SurfaceSample& sample) const;
  /// Mean square [grey^2] of the template after the basis is projected out.
  double mean_projected_energy() const;

  /// [0..1] Variation of the colours: 0 none, near 1 far beyond noise and shading.
  double texture() const { return texture_; }

  double radius() const { return radius_; }  ///< [px at level] of the farthest point

  // All vectors are padded to whole lanes: places with points outside every image, values with
  // zeros.
  std::vector<float> x, y;                   ///< [px at level] relative to the anchor
  std::array<std::vector<float>, 3> planes;  ///< colours
  std::vector<float> brightness;             ///< sum of the channels
  std::vector<int> block_ends;               ///< see SamplePoints

  ShadingBasis basis;                           ///< projected out of template and image
  std::array<std::vector<float>, 3> projected;  ///< `planes` after the basis is projected out
  double projected_energy = 0;                  ///< sum of squares of `projected`

  /// Rows: for each channel projected derivatives along x, y and theta, orthogonal to `projected`,
  /// then `projected` itself. 4 rows of padded() per channel.
  std::array<std::vector<float>, 3> slopes;
  cv::Matx33d slope_product;  ///< products of the slopes, summed over points and channels

  // Texture gradients: unit vector of twice the angle, times weight.
  std::vector<float> gradient_x, gradient_y;
  double gradient_total = 0;

  imaging::ChromaHistogram histogram{};

 private:
  void place_points(cv::Point2d origin);
  void read_colours(const scene::PreparedPixels& image);
  void measure_texture();
  void read_gradients(const scene::PreparedPixels& image);
  void project();
  void read_slopes(const scene::PreparedPixels& image);
  void leave_out_highlights(SurfaceSample& sample) const;

  std::vector<SurfacePoint> points_;
  double radius_ = 1, texture_ = 0;
};

}  // namespace mbncc::templates
