// SPDX-License-Identifier: BSD-3-Clause
// A small object as a camera shows it: its surface under smooth shading, mixed along its edge with
// whatever background the picture has beside it. So few of its pixels lie off the edge that the
// mixed ones have to tell where it lies and which way it is turned.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/edge_mixing.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc {

struct MixedPixelModel {
  static constexpr int kChannels = SurfaceTemplate::kChannels;
  /// Gain of the colours, an offset per axis, two of shading across the object, two of its rim.
  static constexpr int kLight = 8;
  /// Those of them that show along an axis of colour: shading is brightness alone.
  static const std::vector<int>& terms_along(int axis);

  /// Nothing to compare.
  MixedPixelModel() = default;

  /// The object at full resolution, about `anchor` [px].
  MixedPixelModel(const SurfaceTemplate::Source& source, cv::Point2d anchor);

  std::size_t padded() const { return background.size(); }  ///< points, in whole lanes

  /// Turns colours, `count` of each channel, to axes in place: brightness (the channels' sum over
  /// its root), which relief displaces as the light comes, and two across it, which it leaves
  /// alone.
  static void turn_to_axes(float* colours, std::size_t count);

  using SearchMask = std::array<std::vector<float>, 2>;  ///< x and y [px] relative to the anchor

  // All vectors are padded to whole lanes: places with such that lie nowhere, values with zeros.
  SearchMask points;
  std::array<SearchMask, 2> beyond;  ///< where each point's background shows alone
  std::vector<float> background;     ///< [0..1] its share at each point
  /// Per axis, a row for each term along it: what it adds to each point.
  std::array<std::vector<float>, kChannels> light;
  double size = 0;        ///< points
  std::size_t mixed = 0;  ///< of them the first that show some background, in whole lanes
  double radius = 1;      ///< [px] of the farthest point
  double reach = 1;       ///< [px] of the farthest place of all

 private:
  struct Site;
  static bool is_mixed(const Site& site);
  static std::vector<Site> sites_of(const SurfaceTemplate::Source& source, cv::Point2d anchor);
  void place(const std::vector<Site>& sites);
  void lay_out_light(const std::vector<Site>& sites);
};

/// What a picture shows of an object, in the light that explains it best.
struct MixedPixelFit {
  Pose2D pose;
  double misfit = 0;      ///< ln(rms colour difference [grey levels], large ones capped, + 3)
  double brightness = 0;  ///< ln of the object's own, against the lesson's
};

/// At the pose near `start` [px] where the rendering comes nearest to a picture at full resolution;
/// at `start` itself, without anything to tell, where too little is visible.
MixedPixelFit fit(const MixedPixelModel& object, const SceneLevel& scene, const Pose2D& start);

}  // namespace mbncc
