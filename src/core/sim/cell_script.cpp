// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/sim/cell_script.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/random.hpp"

namespace mbncc::sim {
namespace {

constexpr double kBorder = 14;     // [px] between an object's circle and the image's edge
constexpr double kGap = 8;         // [px] between the circles of two objects
constexpr double kBeyond = 260;    // [px] from the image's edge to the waiting grip
constexpr double kShoulder = 500;  // [px] from there to the base of the arm

/// Smooth step from (0, 0) to (1, 1).
double smooth(double progress) {
  return progress * progress * (3 - 2 * progress);
}

Pose2D between(const Pose2D& a, const Pose2D& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          a.theta + share * wrap_angle(b.theta - a.theta)};
}

/// Radius about the centroid that contains the outline. The centroid lies inside the excircle, so
/// the diameter is an upper bound; in practice 0.6 of it is enough.
double reach_of(const SceneObject& object) {
  return 0.6 * object.diameter;
}

bool clear_of(const Pose2D& pose, double reach, const std::vector<Placed>& others) {
  return std::all_of(others.begin(), others.end(), [&](const Placed& other) {
    const double distance = cv::norm(pose.position() - other.pose.position());
    return distance > reach + reach_of(other.object) + kGap;
  });
}

/// A free pose, uniformly distributed. Throws std::invalid_argument if none is found.
Pose2D free_pose(cv::Size size, double reach, const std::vector<Placed>& others, cv::RNG random) {
  const double margin = reach + kBorder;
  for (int attempt = 0; attempt < 1000 && 2 * margin < std::min(size.width, size.height);
       ++attempt) {
    const Pose2D pose{random.uniform(margin, size.width - margin),
                      random.uniform(margin, size.height - margin), random.uniform(-kPi, kPi)};
    if (clear_of(pose, reach, others)) return pose;
  }
  throw std::invalid_argument(
      "the objects do not fit into the image; lower object_diameter or neighbours, or enlarge "
      "width and height");
}

}  // namespace

const char* to_string(CellPhase phase) {
  switch (phase) {
    case CellPhase::kRest:
      return "rest";
    case CellPhase::kReach:
      return "reach";
    case CellPhase::kCarry:
      return "carry";
    case CellPhase::kRetreat:
      return "retreat";
  }
  return "";
}

CellScript::CellScript(CellScriptConfig config) : config_(config) {
  cv::RNG random = generator(config_.seed, 10);
  outside_ = {config_.size.width * random.uniform(0.3, 0.7),
              config_.size.height + kBeyond + config_.object.diameter};
  shoulder_ = outside_ + cv::Point2d(0, kShoulder);
  place_ = Pose2D{config_.size.width / 2.0, config_.size.height / 2.0, 0};
  place_neighbours();
}

void CellScript::place_neighbours() {
  // A stand-in keeps the object's first place free.
  std::vector<Placed> taken{{config_.object, *place_}};
  for (int i = 0; i < config_.neighbours; ++i) {
    SceneObject object;
    object.seed = mix(config_.object.seed, 20 + i);
    object.diameter = 0.8 * config_.object.diameter;
    const cv::RNG random = generator(config_.seed, 20 + i);
    taken.push_back({object, free_pose(config_.size, reach_of(object), taken, random)});
  }
  neighbours_.assign(taken.begin() + 1, taken.end());
  // Throws before the script begins if the cell has no further free place.
  free_pose(config_.size, reach_of(config_.object), neighbours_, generator(config_.seed, 11));
}

Pose2D CellScript::draw_place() {
  const cv::RNG random = generator(config_.seed, 1000 + places_drawn_++);
  return free_pose(config_.size, reach_of(config_.object), neighbours_, random);
}

Pose2D CellScript::grip_at(cv::Point2d position) const {
  const cv::Point2d reach = position - shoulder_;
  return {position.x, position.y, std::atan2(reach.y, reach.x)};
}

Pose2D CellScript::held_at(const Pose2D& object) const {
  return compose(inverse(grip_at(object.position())), object);
}

CellFrame CellScript::frame() const {
  if (!legs_.empty())
    return frame_of(legs_.front(), smooth((leg_frame_ + 1.0) / (config_.leg_frames + 1)));
  CellFrame frame;
  frame.placed = neighbours_;
  if (place_) frame.placed.push_back({config_.object, *place_});
  frame.truth = place_;
  return frame;
}

CellFrame CellScript::frame_of(const Leg& leg, double progress) const {
  CellFrame frame;
  frame.placed = neighbours_;
  frame.phase = leg.phase;
  const Pose2D grip = grip_at(leg.from + (leg.to - leg.from) * progress);
  frame.arm = Arm{grip, 0.75 * config_.object.diameter};
  if (leg.held_from) {
    const Pose2D held = between(*leg.held_from, *leg.held_to, progress);
    frame.placed.push_back({config_.object, compose(grip, held)});
  } else if (leg.lying) {
    frame.placed.push_back({config_.object, *leg.lying});
  }
  frame.truth = leg.lying;
  return frame;
}

bool CellScript::take_away() {
  if (!at_rest() || !place_) return false;
  const Pose2D held = held_at(*place_);
  const cv::Point2d from = place_->position();
  legs_ = {{CellPhase::kReach, outside_, from, place_, {}, {}},
           {CellPhase::kCarry, from, outside_, {}, held, held}};
  place_.reset();
  return true;
}

bool CellScript::put_next() {
  if (!at_rest()) return false;
  const Pose2D next = draw_place();
  const Pose2D held = held_at(next), held_before = place_ ? held_at(*place_) : held;
  const cv::Point2d from = place_ ? place_->position() : outside_, to = next.position();
  if (place_) legs_.push_back({CellPhase::kReach, outside_, from, place_, {}, {}});
  legs_.push_back({CellPhase::kCarry, from, to, {}, held_before, held});
  legs_.push_back({CellPhase::kRetreat, to, outside_, next, {}, {}});
  place_ = next;
  return true;
}

void CellScript::step() {
  if (legs_.empty()) {
    if (!config_.auto_play || ++rest_frame_ < config_.rest_frames) return;
    place_ ? take_away() : put_next();
    return;
  }
  if (++leg_frame_ < config_.leg_frames) return;
  legs_.erase(legs_.begin());
  leg_frame_ = 0;
  rest_frame_ = 0;
}

}  // namespace mbncc::sim
