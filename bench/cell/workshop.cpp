// SPDX-License-Identifier: BSD-3-Clause
#include "cell/workshop.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/clock.hpp"

namespace mbncc::bench {
namespace {

constexpr double kArmHalf = 80;   // [px] half width of the arm with its shadow
constexpr double kMostShift = 3;  // [px]
constexpr double kMostTurn = to_radians(3);
constexpr int kBeats = 60, kGone = 44;  // images per round, and until the arm is gone
const cv::Size kSize(640, 480);

sim::SceneObject drawing_of(int index, int seed) {
  cv::RNG random(static_cast<std::uint64_t>(1000 * seed + index + 1));
  return {static_cast<std::uint64_t>(1000 * seed + index + 1), random.uniform(40., 75.),
          random.uniform(1.1, 2.2)};
}

std::string name_of(int index) {
  return "part" + std::to_string(index);
}

std::shared_ptr<const ObjectModel> learned(const sim::SceneObject& drawing, int index) {
  const sim::Scene scene;
  const sim::Placed placed{drawing, {320, 240, 0}};
  auto model = std::make_shared<ObjectModel>();
  model->name = name_of(index);
  model->views = {crop_view(scene.render({placed}, 1), scene.true_map(placed), placed.pose)};
  return model;
}

}  // namespace

Workshop::Workshop(int objects, int lying, int seed) : random_(static_cast<std::uint64_t>(seed)) {
  sim::SceneConfig config;
  config.seed = static_cast<std::uint64_t>(seed);
  scene_ = sim::Scene(config);
  std::vector<std::shared_ptr<const ObjectModel>> models;
  for (int i = 0; i < objects; ++i) {
    drawings_.push_back(drawing_of(i, seed));
    models.push_back(learned(drawings_.back(), i));
  }
  matcher_.set_objects(models);
  for (int i = 0; i < lying; ++i) add(i);
}

void Workshop::add(int index) {
  const auto& drawing = drawings_[static_cast<std::size_t>(index)];
  lying_.push_back({index, {drawing, free_pose(drawing)}});
}

Pose2D Workshop::free_pose(const sim::SceneObject& drawing, int self) {
  const double reach = 0.6 * drawing.diameter;
  for (int attempt = 0; attempt < 20000; ++attempt) {
    const Pose2D pose{random_.uniform(reach + 6, kSize.width - reach - 6),
                      random_.uniform(reach + 6, kSize.height - reach - 6),
                      random_.uniform(-kPi, kPi)};
    bool free = true;
    for (const auto& one : lying_)
      free &= one.index == self || cv::norm(one.placed.pose.position() - pose.position()) >
                                       reach + 0.6 * one.placed.object.diameter;
    if (free) return pose;
  }
  throw std::runtime_error("the objects do not fit into the image");
}

double Workshop::show(double light, const std::optional<sim::Arm>& arm) {
  std::vector<sim::Placed> placed;
  for (const auto& one : lying_) placed.push_back(one.placed);
  image_ = scene_.render(placed, frames_, arm) * light;
  const double stamp = kFrameTime * static_cast<double>(frames_++);
  return cpu_ms_of([&] { result_ = video_.find(matcher_, stamp, image_); });
}

double Workshop::search_whole() {
  return cpu_ms_of([&] { whole_ = matcher_.find(image_); });
}

const Match* Workshop::right_one(const SearchResult& result, const Lying& one) const {
  for (const auto& match : result.matches)
    if (match.name == name_of(one.index) &&
        cv::norm(match.pose.position() - one.placed.pose.position()) <= kMostShift &&
        angle_distance(match.pose.theta, one.placed.pose.theta, match.symmetry) <= kMostTurn)
      return &match;
  return nullptr;
}

std::optional<sim::Arm> Story::step() {
  const int beat = count_++ % kBeats;
  if (beat == 0) begin();
  if (beat >= kGone) return std::nullopt;
  const double share = std::min({1.0, beat / 14.0, (kGone - 1 - beat) / 14.0});
  sim::Arm arm{grip_at(share)};
  if (held_ && beat >= 14) carry(arm, beat);
  return arm;
}

void Story::begin() {
  auto& lying = workshop_.lying();
  Lying& one = lying[static_cast<std::size_t>(
      workshop_.random().uniform(0, static_cast<int>(lying.size())))];
  from_ = one.placed.pose;
  held_ = workshop_.random().uniform(0, 3) > 0 ? &one : nullptr;
  to_ = held_ ? workshop_.free_pose(one.placed.object, one.index) : from_;
}

Pose2D Story::grip_at(double share) const {
  const cv::Point2d outside(from_.x, kSize.height + 180.);
  const cv::Point2d grip = outside + (from_.position() - outside) * share;
  return {grip.x, grip.y, -kPi / 2};
}

void Story::carry(sim::Arm& arm, int beat) {
  const double share = std::min(1.0, (beat - 14) / 15.0);
  Pose2D& pose = held_->placed.pose;
  pose = {from_.x + share * (to_.x - from_.x), from_.y + share * (to_.y - from_.y),
          from_.theta + share * wrap_angle(to_.theta - from_.theta)};
  held_->held = share < 1;
  const double away = std::max(0.0, (beat - 29) / 14.0);
  arm.grip = {pose.x, pose.y + away * (kSize.height + 180 - pose.y), -kPi / 2};
}

bool is_covered(const Lying& one, const std::optional<sim::Arm>& arm) {
  if (!arm) return false;
  const cv::Point2d off = one.placed.pose.position() - arm->grip.position();
  const double reach = 0.6 * one.placed.object.diameter;
  return std::abs(off.x) < kArmHalf + reach && off.y > -reach - 30;  // it reaches in from below
}

}  // namespace mbncc::bench
