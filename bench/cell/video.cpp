// Watching a workshop: what a still scene, single changes and a long video cost, and what is found
// in it, with a library of taught objects of which some lie in the picture.
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "common/clock.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"
#include "mbncc/cell/video_search.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@out    |      | folder for video.csv }"
    "{frames  | 3000 | pictures of the video }"
    "{objects | 40   | taught objects }"
    "{lying   | 12   | of these, in the picture }"
    "{seed    | 1    | draws objects and story }"
    "{help h  |      | this text }";

constexpr double kFrameTime = 1. / 30;            // [s]
constexpr double kDrift = 0.1, kFlicker = 0.015;  // of the light
constexpr double kArmHalf = 80;                   // [px] with its shadow
constexpr double kMostShift = 3;                  // [px]
constexpr double kMostTurn = to_radians(3);
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

/// An object in the picture.
struct Lying {
  int index;
  sim::Placed placed;
  bool held = false;
  int overlooked = 0;  ///< pictures in a row
};

/// The workshop, its camera and who watches it.
class Workshop {
 public:
  Workshop(int objects, int lying, int seed) : random_(static_cast<std::uint64_t>(seed)) {
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

  void add(int index) {
    const auto& drawing = drawings_[static_cast<std::size_t>(index)];
    lying_.push_back({index, {drawing, free_pose(drawing)}});
  }

  /// A place where nothing lies; the object itself does not count.
  Pose2D free_pose(const sim::SceneObject& drawing, int self = -1) {
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
    throw std::runtime_error("the objects do not fit into the picture");
  }

  /// Renders and searches the next picture; thread CPU ms of the search.
  double show(double light = 1, const std::optional<sim::Arm>& arm = {}) {
    std::vector<sim::Placed> placed;
    for (const auto& one : lying_) placed.push_back(one.placed);
    picture_ = scene_.render(placed, frames_, arm) * light;
    const double stamp = kFrameTime * static_cast<double>(frames_++);
    return cpu_ms_of([&] { result_ = video_.find(matcher_, stamp, picture_); });
  }

  double search_whole() {
    return cpu_ms_of([&] { whole_ = matcher_.find(picture_); });
  }

  const Match* right_one(const SearchResult& result, const Lying& one) const {
    for (const auto& match : result.matches)
      if (match.name == name_of(one.index) &&
          cv::norm(match.pose.position() - one.placed.pose.position()) <= kMostShift &&
          angle_distance(match.pose.theta, one.placed.pose.theta, match.symmetry) <= kMostTurn)
        return &match;
    return nullptr;
  }

  const SearchResult& result() const { return result_; }
  const SearchResult& whole() const { return whole_; }
  std::vector<Lying>& lying() { return lying_; }
  cv::RNG& random() { return random_; }

 private:
  cv::RNG random_;
  sim::Scene scene_;
  std::vector<sim::SceneObject> drawings_;
  Matcher matcher_;
  VideoSearch video_;
  std::vector<Lying> lying_;
  cv::Mat picture_;
  SearchResult result_, whole_;
  std::uint64_t frames_ = 0;
};

double yardstick_ms() {
  MatchYardstick yardstick;
  std::vector<double> times;
  for (int i = 0; i < 15; ++i) times.push_back(cpu_ms_of([&] { yardstick.run(); }));
  return median(times);
}

std::vector<std::string> cost_row(const std::string& what, const std::vector<double>& times,
                                  double yardstick) {
  return {what,
          std::to_string(times.size()),
          to_text(mean(times), 3),
          to_text(median(times), 3),
          to_text(percentile(times, 99), 3),
          to_text(mean(times) / yardstick, 3),
          to_text(median(times) / yardstick, 3),
          to_text(percentile(times, 99) / yardstick, 3)};
}

void settle(Workshop& workshop) {
  for (int i = 0; i < 300; ++i) workshop.show();
}

void measure_still(Workshop& workshop, double yardstick, Table& table) {
  settle(workshop);
  std::vector<double> still, whole;
  for (int i = 0; i < 900; ++i) still.push_back(workshop.show());
  for (int i = 0; i < 5; ++i) whole.push_back(workshop.search_whole());
  table.rows.push_back(cost_row("every picture searched whole", whole, yardstick));
  table.rows.push_back(cost_row("still scene", still, yardstick));
}

/// What `change` does to the first object costs, in the pictures until nothing is owed any more.
template <class Change>
void measure_change(Workshop& workshop, const std::string& what, double yardstick, Table& table,
                    Table& delays, const Change& change) {
  std::vector<double> times, until_found, until_graspable;
  for (int i = 0; i < 12; ++i) {
    Lying& one = change();
    int found = -1, graspable = -1;
    for (int k = 0; k < 60; ++k) {
      const double ms = workshop.show();
      if (k == 0 || !workshop.result().skipped.empty() || found < 0) times.push_back(ms);
      const Match* match = workshop.right_one(workshop.result(), one);
      if (match && found < 0) found = k;
      if (match && match->graspable && graspable < 0) graspable = k;
    }
    until_found.push_back(found < 0 ? 60 : found);
    until_graspable.push_back(graspable < 0 ? 60 : graspable);
  }
  table.rows.push_back(cost_row("one object " + what, times, yardstick));
  delays.rows.push_back(
      {what, to_text(median(until_found), 0), to_text(percentile(until_found, 100), 0),
       to_text(median(until_graspable), 0), to_text(percentile(until_graspable, 100), 0)});
}

/// Every 60 pictures the arm comes, and carries an object elsewhere, or only reaches over some.
class Story {
 public:
  explicit Story(Workshop& workshop) : workshop_(workshop) {}

  std::optional<sim::Arm> step() {
    const int beat = count_++ % kBeats;
    if (beat == 0) begin();
    if (beat >= kRest) return std::nullopt;
    const double share = std::min({1.0, beat / 14.0, (kRest - 1 - beat) / 14.0});
    sim::Arm arm{grip_at(share)};
    if (held_ && beat >= 14) carry(arm, beat);
    return arm;
  }

 private:
  static constexpr int kBeats = 60, kRest = 44;

  void begin() {
    auto& lying = workshop_.lying();
    Lying& one = lying[static_cast<std::size_t>(
        workshop_.random().uniform(0, static_cast<int>(lying.size())))];
    from_ = one.placed.pose;
    held_ = workshop_.random().uniform(0, 3) > 0 ? &one : nullptr;
    to_ = held_ ? workshop_.free_pose(one.placed.object, one.index) : from_;
  }

  Pose2D grip_at(double share) const {
    const cv::Point2d outside(from_.x, kSize.height + 180.);
    const cv::Point2d grip = outside + (from_.position() - outside) * share;
    return {grip.x, grip.y, -kPi / 2};
  }

  void carry(sim::Arm& arm, int beat) {
    const double share = std::min(1.0, (beat - 14) / 15.0);
    Pose2D& pose = held_->placed.pose;
    pose = {from_.x + share * (to_.x - from_.x), from_.y + share * (to_.y - from_.y),
            from_.theta + share * wrap_angle(to_.theta - from_.theta)};
    held_->held = share < 1;
    const double away = std::max(0.0, (beat - 29) / 14.0);
    arm.grip = {pose.x, pose.y + away * (kSize.height + 180 - pose.y), -kPi / 2};
  }

  Workshop& workshop_;
  int count_ = 0;
  Lying* held_ = nullptr;
  Pose2D from_, to_;
};

bool is_covered(const Lying& one, const std::optional<sim::Arm>& arm) {
  if (!arm) return false;
  const cv::Point2d off = one.placed.pose.position() - arm->grip.position();
  const double reach = 0.6 * one.placed.object.diameter;
  return std::abs(off.x) < kArmHalf + reach && off.y > -reach - 30;  // it reaches up from below
}

struct Tally {
  int visible = 0, found = 0, reported = 0, right = 0, graspable = 0, graspable_right = 0;
  int longest = 0;  ///< [pictures] that a visible object was overlooked
  int whole_visible = 0, whole_found = 0, whole_reported = 0;
};

void judge(Workshop& workshop, const std::optional<sim::Arm>& arm, Tally& tally) {
  std::vector<const Match*> right;
  for (auto& one : workshop.lying()) {
    const Match* match = workshop.right_one(workshop.result(), one);
    if (match) right.push_back(match);
    if (one.held || is_covered(one, arm)) {
      one.overlooked = 0;
      continue;
    }
    ++tally.visible;
    tally.found += match != nullptr;
    one.overlooked = match ? 0 : one.overlooked + 1;
    tally.longest = std::max(tally.longest, one.overlooked);
  }
  for (const auto& match : workshop.result().matches) {
    const bool is_right = std::find(right.begin(), right.end(), &match) != right.end();
    ++tally.reported;
    tally.right += is_right;
    tally.graspable += match.graspable;
    tally.graspable_right += match.graspable && is_right;
  }
}

void judge_whole(Workshop& workshop, const std::optional<sim::Arm>& arm, Tally& tally) {
  workshop.search_whole();
  for (const auto& one : workshop.lying()) {
    if (one.held || is_covered(one, arm)) continue;
    ++tally.whole_visible;
    tally.whole_found += workshop.right_one(workshop.whole(), one) != nullptr;
  }
}

void measure_video(Workshop& workshop, int frames, double yardstick, Table& table) {
  Story story(workshop);
  Tally tally;
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) {
    const auto arm = story.step();
    const double light = 1 + kDrift * std::sin(2 * kPi * i / 1500.) + kFlicker * std::sin(2.1 * i) +
                         workshop.random().gaussian(0.003);
    times.push_back(workshop.show(light, arm));
    judge(workshop, arm, tally);
    if (i % 50 == 25) judge_whole(workshop, arm, tally);
  }
  table.rows.push_back(cost_row("video", times, yardstick));
  const auto share = [](int a, int b) {
    return to_text(static_cast<double>(a) / std::max(1, b), 4);
  };
  write_markdown(
      std::cout,
      {{"frames", "recall", "precision", "graspable right", "longest overlooked s",
        "recall of whole searches"},
       {{std::to_string(frames), share(tally.found, tally.visible),
         share(tally.right, tally.reported),
         std::to_string(tally.graspable_right) + "/" + std::to_string(tally.graspable),
         to_text(kFrameTime * tally.longest, 2), share(tally.whole_found, tally.whole_visible)}}});
}

void benchmark(const cv::CommandLineParser& options) {
  const int lying = options.get<int>("lying"), objects = options.get<int>("objects");
  Workshop workshop(objects, lying, options.get<int>("seed"));
  const double yardstick = yardstick_ms();
  std::cout << "Yardstick " << to_text(yardstick, 1) << " ms.\n";
  Table costs{{"pictures", "n", "mean ms", "median ms", "99 % ms", "mean ratio", "median ratio",
               "99 % ratio"},
              {}};
  Table delays{{"one object", "median pictures until found", "most", "until graspable", "most"},
               {}};
  measure_still(workshop, yardstick, costs);
  auto& first = workshop.lying().front();
  measure_change(workshop, "moved", yardstick, costs, delays, [&]() -> Lying& {
    first.placed.pose = workshop.free_pose(first.placed.object, first.index);
    return first;
  });
  measure_change(workshop, "turned", yardstick, costs, delays, [&]() -> Lying& {
    first.placed.pose.theta =
        wrap_angle(first.placed.pose.theta + workshop.random().uniform(0.3, 3.));
    return first;
  });
  int next = lying;
  measure_change(workshop, "added", yardstick, costs, delays, [&]() -> Lying& {
    if (next > lying) workshop.lying().pop_back();
    for (int i = 0; i < 60; ++i) workshop.show();
    workshop.add(next);
    next = next + 1 < objects ? next + 1 : lying;
    return workshop.lying().back();
  });
  write_markdown(std::cout, delays);
  measure_video(workshop, options.get<int>("frames"), yardstick, costs);
  save_csv(options.get<std::string>("@out") + "/video.csv", costs);
  write_markdown(std::cout, costs);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "video_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
