// SPDX-License-Identifier: BSD-3-Clause
// Image model of a small object: its surface under smooth shading, mixed at its edge with the
// picture's background. A small object has so few inner pixels that the mixed ones must determine
// its pose.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/edge_mixing.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::refinement {

struct MixedPixelModel {
  static constexpr int kChannels = templates::SurfaceTemplate::kChannels;
  /// Gain of the colours, an offset per axis, two of shading across the object, two of its rim.
  static constexpr int kLight = 8;
  /// The terms of an axis of colour, because shading affects only brightness.
  static const std::vector<int>& terms_along(int axis);

  /// Empty, without a surface.
  MixedPixelModel() = default;

  /// The object at full resolution, about `anchor` [px].
  MixedPixelModel(const templates::SurfaceTemplate::Source& source, cv::Point2d anchor);

  std::size_t padded() const { return background.size(); }  ///< points, in whole lanes

  /// Transforms colours, `count` of each channel, to axes in place: brightness (the channels' sum
  /// over its root), which relief displaces depending on the light, and two orthogonal to it, which
  /// it does not.
  static void turn_to_axes(float* colours, std::size_t count);

  using SearchMask = std::array<std::vector<float>, 2>;  ///< x and y [px] relative to the anchor

  // All vectors are padded to whole lanes: places with points outside every picture, values with
  // zeros.
  SearchMask points;
  std::array<SearchMask, 2> beyond;  ///< where each point's background is visible alone
  std::vector<float> background;     ///< [0..1] its share at each point
  /// Per axis, a row for each term: its contribution to each point.
  std::array<std::vector<float>, kChannels> light;
  double size = 0;        ///< points
  std::size_t mixed = 0;  ///< the first of them, with visible background, in whole lanes
  double radius = 1;      ///< [px] of the farthest point
  double reach = 1;       ///< [px] of the farthest place of all

 private:
  struct Site;
  static bool is_mixed(const Site& site);
  static std::vector<Site> sites_of(const templates::SurfaceTemplate::Source& source,
                                    cv::Point2d anchor);
  void place(const std::vector<Site>& sites);
  void lay_out_light(const std::vector<Site>& sites);
};

/// Result of a fit, in the light that best explains the picture.
struct MixedPixelFit {
  Pose2D pose;
  double misfit = 0;      ///< ln(rms colour difference [grey levels], large ones capped, + 3)
  double brightness = 0;  ///< ln of the object's own, against the lesson's
};

/// At the pose near `start` [px] with the smallest residual in a picture at full resolution; at
/// `start` itself, without a result, if too little is visible.
MixedPixelFit fit(const MixedPixelModel& object, const scene::SceneLevel& scene,
                  const Pose2D& start);

}  // namespace mbncc::refinement
