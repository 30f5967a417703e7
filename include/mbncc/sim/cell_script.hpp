// SPDX-License-Identifier: BSD-3-Clause
// The story that the simulated camera plays: an object lies on the platform, an arm takes it away,
// later puts it down elsewhere, turned. One step per picture; the same seed tells the same story.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/geometry.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::sim {

struct CellScriptConfig {
  cv::Size size{640, 480};  ///< [px] of the picture
  std::uint64_t seed = 1;   ///< draws places and neighbours
  SceneObject object;       ///< the one that is moved
  int neighbours = 2;       ///< other objects that lie still
  bool auto_play = true;    ///< moves by itself; else only when told to
  int rest_frames = 50;     ///< pictures at rest between two motions, with auto_play
  int leg_frames = 15;      ///< pictures of one leg of a motion: reach, carry, retreat
};

enum class CellPhase { kRest, kReach, kCarry, kRetreat };

/// "rest", "reach", "carry" or "retreat".
const char* to_string(CellPhase phase);

/// What one picture shows.
struct CellFrame {
  std::vector<Placed> placed;   ///< neighbours, and the object unless it is out of the cell
  std::optional<Arm> arm;       ///< none: out of the picture
  std::optional<Pose2D> truth;  ///< where the object lies; none while it is carried or out
  CellPhase phase = CellPhase::kRest;
};

/// Plays the story. It begins with the object lying at angle 0 in the middle of the picture. With
/// auto_play it is taken away and put down elsewhere in turn, for ever.
class CellScript {
 public:
  /// Throws std::invalid_argument when the objects do not fit into the picture.
  explicit CellScript(CellScriptConfig config = {});

  /// What the picture of this moment shows.
  CellFrame frame() const;

  /// Goes on by one picture.
  void step();

  /// Begins to carry the object out. False, and nothing happens, unless it lies at rest.
  bool take_away();

  /// Begins to put the object down at the next place, coming from outside or from where it lies.
  /// False, and nothing happens, unless the cell is at rest.
  bool put_next();

  bool at_rest() const { return legs_.empty(); }

  /// Where the object lies at rest or is heading for; none: outside.
  const std::optional<Pose2D>& place() const { return place_; }

 private:
  /// A stretch of the arm's way. The object lies on the platform, or is held at a pose about the
  /// grip that turns from one to another, or is out.
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
  cv::Point2d outside_;   // [px] where the grip waits
  std::vector<Placed> neighbours_;
  std::uint64_t places_drawn_ = 0;
  std::optional<Pose2D> place_;
  std::vector<Leg> legs_;  // still to be gone, the first one under way
  int leg_frame_ = 0;
  int rest_frame_ = 0;
};

}  // namespace mbncc::sim
