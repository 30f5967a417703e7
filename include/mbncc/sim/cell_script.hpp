// SPDX-License-Identifier: BSD-3-Clause
// The script of the simulated camera: an object lies on the platform; an arm takes it away and
// later puts it down at another place and angle. One step per image; the same seed gives the same
// script.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/geometry.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::sim {

struct CellScriptConfig {
  cv::Size size{640, 480};  ///< [px] of the image
  std::uint64_t seed = 1;   ///< seed of the places and neighbours
  SceneObject object;       ///< the object that is moved
  int neighbours = 2;       ///< other objects that lie still
  bool auto_play = true;    ///< moves automatically; otherwise only on request
  int rest_frames = 50;     ///< images at rest between two motions, with auto_play
  int leg_frames = 15;      ///< images of one leg of a motion: reach, carry, retreat
};

enum class CellPhase { kRest, kReach, kCarry, kRetreat };

/// "rest", "reach", "carry" or "retreat".
const char* to_string(CellPhase phase);

/// Contents of one image.
struct CellFrame {
  std::vector<Placed> placed;   ///< neighbours, and the object unless it is out of the cell
  std::optional<Arm> arm;       ///< none: out of the image
  std::optional<Pose2D> truth;  ///< pose at which the object lies; none while it is carried or out
  CellPhase phase = CellPhase::kRest;
};

/// Plays the script. It begins with the object at angle 0 in the middle of the image. With
/// auto_play the object is repeatedly taken away and put down elsewhere.
class CellScript {
 public:
  /// Throws std::invalid_argument if the objects do not fit into the image.
  explicit CellScript(CellScriptConfig config = {});

  /// Contents of the current image.
  CellFrame frame() const;

  /// Advances by one image.
  void step();

  /// Begins to carry the object out. Returns false and does nothing unless it lies at rest.
  bool take_away();

  /// Begins to put the object down at the next place, starting from outside or from its current
  /// place. Returns false and does nothing unless the cell is at rest.
  bool put_next();

  bool at_rest() const { return legs_.empty(); }

  /// Current or next resting pose of the object; none if it is outside.
  const std::optional<Pose2D>& place() const { return place_; }

 private:
  /// A segment of the arm's path. The object lies on the platform, is held at an interpolated pose
  /// relative to the grip, or is outside.
  struct Leg {
    CellPhase phase = CellPhase::kRest;
    cv::Point2d from, to;  // [px] grip
    std::optional<Pose2D> lying;
    std::optional<Pose2D> held_from, held_to;
  };

  void place_neighbours();
  Pose2D draw_place();
  Pose2D grip_at(cv::Point2d position) const;
  Pose2D held_at(const Pose2D& object) const;
  CellFrame frame_of(const Leg& leg, double progress) const;

  CellScriptConfig config_;
  cv::Point2d shoulder_;  // [px] the arm's base
  cv::Point2d outside_;   // [px] position where the grip waits
  std::vector<Placed> neighbours_;
  std::uint64_t places_drawn_ = 0;
  std::optional<Pose2D> place_;
  std::vector<Leg> legs_;  // remaining segments; the first one is in progress
  int leg_frame_ = 0;
  int rest_frame_ = 0;
};

}  // namespace mbncc::sim
