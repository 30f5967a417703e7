// Coarse search by the map's edge: finds objects whose surface looks different under other light.
// After LINE-MOD (Hinterstoisser et al. 2012), with signed responses, so that clutter averages out.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/candidate.hpp"
#include "matching/contour_template.hpp"
#include "matching/places.hpp"
#include "matching/rotation_sector.hpp"
#include "matching/scene_level.hpp"

namespace mbncc {

/// The contour turned to all rotations at one pyramid level.
class EdgeBank {
 public:
  /// `anchor` [px, level 0]; the level is chosen by the contour's size.
  EdgeBank(const MapGeometry& map, cv::Point2d anchor);

  struct Point {
    int x, y;         ///< [px] relative to the anchor's pixel
    int orientation;  ///< of the normal, modulo a half turn
  };
  struct Rotation {
    double angle;  ///< [rad]
    std::vector<Point> points;
  };

  int level() const { return level_; }
  int radius() const { return radius_; }  ///< [px at level]
  const std::vector<Rotation>& rotations() const { return rotations_; }
  bool round() const { return round_; }  ///< the contour does not tell the rotation

 private:
  int level_ = 0, radius_ = 0;
  std::vector<Rotation> rotations_;
  bool round_ = false;
};

struct EdgeCandidates {
  std::vector<Candidate> poses;         ///< value: mean response [-1..1]
  std::vector<Candidate> round_places;  ///< places where the contour does not tell the rotation
};

/// The best `most` poses in `roi` [px at the bank's level], `sector` and `places`. `scene` is that
/// level.
EdgeCandidates edge_search(const EdgeBank& bank, const SceneLevel& scene, const cv::Rect& roi,
                           int most, const RotationSector& sector = {}, const Places& places = {});

}  // namespace mbncc
