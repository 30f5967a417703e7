// Live lessons in the simulated cell: an operator who hesitates, reaches in, pauses, puts things
// down first or aside, under flickering and drifting light. How many are stored, and how well?
#include <filesystem>
#include <iostream>
#include <optional>

#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "mbncc/cell/demonstration.hpp"
#include "mbncc/cell/scene_watch.hpp"
#include "mbncc/cell/second_look.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/sim/cell_script.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@out    |     | folder for lessons.csv }"
    "{lessons | 100 | number of lessons }"
    "{seed    | 1   | draws them }"
    "{help h  |     | this text }";

constexpr double kFrameTime = 0.1;                 // [s]
constexpr int kPatience = 400;                     // pictures until a lesson times out
constexpr double kLeastIou = 0.8, kMostShift = 2;  // [px]
constexpr double kMostTurn = to_radians(2);
constexpr double kFlicker = 0.015, kDrift = 0.06;  // of the light

/// How the operator shows the object.
enum class Way { kTakenAway, kPutAside, kAlreadyMoved, kPutDownFirst };
const char* const kWayNames[] = {"taken away", "put aside", "already moved", "put down first"};

/// The cell and its camera, one picture at a time.
class Cell {
 public:
  Cell(std::uint64_t seed, cv::RNG& random)
      : random_(random), scene_(scene_config(seed)), script_(script_config(seed, random)) {
    drift_ = random.uniform(-kDrift, kDrift);
    phase_ = random.uniform(0., 2 * kPi);
  }

  void show(const std::optional<sim::Arm>& intruder = {}) {
    const sim::CellFrame frame = script_.frame();
    const cv::Mat picture = scene_.render(frame.placed, frames_, intruder ? intruder : frame.arm);
    const double t = static_cast<double>(frames_++);
    const double light = 1 + drift_ * t / kPatience + kFlicker * std::sin(phase_ + 2.1 * t) +
                         random_.gaussian(0.003);
    cv::Mat lit;
    picture.convertTo(lit, -1, light);
    watch.update(1000 + kFrameTime * t, lit);
    script_.step();
  }

  void rest(int pictures) {
    for (int i = 0; i < pictures; ++i) show();
  }

  void finish_motion() {
    while (!script_.at_rest()) show();
  }

  /// An arm reaches in from below, pauses, and leaves again.
  void reach_in() {
    const cv::Point2d to(random_.uniform(100., 540.), random_.uniform(60., 400.));
    const int pause = random_.uniform(0, 12);
    for (int i = 0; i < 20 + pause; ++i) {
      const double share = std::min({1.0, i / 10.0, (19 + pause - i) / 10.0});
      const cv::Point2d from(to.x, 760);
      const cv::Point2d grip = from + (to - from) * share;
      show(sim::Arm{{grip.x, grip.y, -kPi / 2}});
    }
  }

  cv::Mat map_of(const Pose2D& pose) const { return scene_.true_map({object_, pose}); }
  cv::Mat picture() { return scene_.render(script_.frame().placed, 77777 + frames_++); }
  sim::CellScript& script() { return script_; }

  SceneWatch watch{0.5};

 private:
  static sim::SceneConfig scene_config(std::uint64_t seed) {
    sim::SceneConfig config;
    config.seed = seed;
    return config;
  }

  sim::CellScriptConfig script_config(std::uint64_t seed, cv::RNG& random) {
    sim::CellScriptConfig config;
    config.seed = seed;
    config.object = {seed, random.uniform(60., 130.), random.uniform(1.1, 2.5)};
    config.neighbours = random.uniform(0, 4);
    config.auto_play = false;
    config.leg_frames = random.uniform(6, 20);
    object_ = config.object;
    return config;
  }

  cv::RNG& random_;
  sim::SceneObject object_;
  sim::Scene scene_;
  sim::CellScript script_;
  std::uint64_t frames_ = 0;
  double drift_ = 0, phase_ = 0;
};

struct Outcome {
  LearnResult learned;
  Pose2D shown;  ///< where the object lay in the picture before
  bool timed_out = false;
};

/// One lesson with its operator.
class Demo {
 public:
  Demo(Cell& cell, Way way, cv::RNG& random) : cell_(cell), way_(way), random_(random) {}

  Outcome run() {
    if (way_ == Way::kAlreadyMoved) return already_moved();
    if (way_ == Way::kPutDownFirst) {
      cell_.script().take_away();
      cell_.finish_motion();
    }
    cell_.rest(random_.uniform(0, 12));
    Demonstration demonstration;
    for (int i = 0; i < kPatience; ++i) {
      const auto step = demonstration.look(cell_.watch.still());
      if (step == Demonstration::Step::kReady) {
        Outcome outcome = learn(demonstration.before().picture, demonstration.after().picture);
        if (outcome.learned.error != LearnError::kNoChange && has_left(outcome, demonstration))
          return outcome;
        demonstration.go_on();
      } else if (step == Demonstration::Step::kWaitRemoval) {
        act();
      }
      cell_.show();
    }
    Outcome late;
    late.timed_out = true;
    return late;
  }

 private:
  static bool has_left(const Outcome& outcome, const Demonstration& demonstration) {
    const LearnResult& learned = outcome.learned;
    return !learned.has_model || part_put_down(full_size_map(learned.object.views.front()),
                                               demonstration.before().picture,
                                               demonstration.after().picture) < kMostPutDown;
  }

  /// What the operator does when told to take the object away; after some hesitation.
  void act() {
    if (!cell_.script().at_rest() || hesitation_-- > 0) return;
    hesitation_ = 25;
    if (intrusions_-- > 0) return cell_.reach_in();
    const bool lies = cell_.script().place().has_value();
    if (!lies) {
      cell_.script().put_next();
      return;
    }
    shown_ = *cell_.script().place();
    way_ == Way::kPutAside ? cell_.script().put_next() : cell_.script().take_away();
  }

  Outcome already_moved() {
    cell_.rest(random_.uniform(12, 25));
    if (intrusions_ > 0) cell_.reach_in();
    cell_.rest(12);
    shown_ = *cell_.script().place();
    cell_.script().take_away();
    cell_.finish_motion();
    cell_.rest(12);
    const auto after = cell_.watch.still(), before = cell_.watch.before_change();
    if (!after || !before) {
      Outcome late;
      late.timed_out = true;
      return late;
    }
    return learn(before->picture, after->picture);
  }

  Outcome learn(const cv::Mat& before, const cv::Mat& after) const {
    Lesson lesson;
    lesson.name = "part";
    lesson.before = before;
    lesson.after = after;
    return {learn_object(lesson), shown_, false};
  }

  Cell& cell_;
  const Way way_;
  cv::RNG& random_;
  int hesitation_ = random_.uniform(0, 10);
  int intrusions_ = random_.uniform(0, 3);
  Pose2D shown_;
};

double iou(const cv::Mat& a, const cv::Mat& b) {
  return static_cast<double>(cv::countNonZero(a & b)) / std::max(1, cv::countNonZero(a | b));
}

/// Put down at the next place, is it found there?
bool is_found_next(Cell& cell, const Outcome& outcome) {
  cell.finish_motion();
  cell.script().put_next();
  cell.finish_motion();
  Matcher matcher;
  matcher.set_objects({std::make_shared<ObjectModel>(outcome.learned.object)});
  const auto matches = matcher.find(cell.picture()).matches;
  if (matches.empty()) return false;
  const Pose2D reference = outcome.learned.object.views.front().reference;
  const Pose2D expected =
      compose(compose(*cell.script().place(), inverse(outcome.shown)), reference);
  const Pose2D& found = matches.front().pose;
  return cv::norm(found.position() - expected.position()) <= kMostShift &&
         angle_distance(found.theta, expected.theta) <= kMostTurn;
}

struct Tally {
  int lessons = 0, right = 0, wrong = 0, refused = 0, late = 0;
  std::vector<double> ious;
};

void judge(Cell& cell, const Outcome& outcome, Tally& tally, std::vector<std::string>& row) {
  ++tally.lessons;
  if (outcome.timed_out) {
    ++tally.late;
    row.insert(row.end(), {"timed out", "", ""});
    return;
  }
  const LearnResult& learned = outcome.learned;
  if (learned.error != LearnError::kSuccess) {
    ++tally.refused;
    row.insert(row.end(), {to_string(learned.error), "", ""});
    return;
  }
  const double agreement =
      iou(full_size_map(learned.object.views.front()), cell.map_of(outcome.shown));
  const bool found = is_found_next(cell, outcome);
  tally.ious.push_back(agreement);
  ++(agreement >= kLeastIou && found ? tally.right : tally.wrong);
  row.insert(row.end(), {"stored " + std::string(to_string(learned.object.quality.verdict)),
                         to_text(agreement, 3), found ? "found" : "not found"});
}

std::vector<std::string> row_of(const std::string& way, const Tally& tally) {
  return {way,
          std::to_string(tally.lessons),
          std::to_string(tally.right),
          std::to_string(tally.wrong),
          std::to_string(tally.refused),
          std::to_string(tally.late),
          to_text(median(tally.ious), 3),
          to_text(percentile(tally.ious, 5), 3)};
}

void benchmark(const cv::CommandLineParser& options) {
  const std::filesystem::path out = output_folder(options.get<std::string>("@out"));
  const int lessons = options.get<int>("lessons"), seed = options.get<int>("seed");
  Table cases{{"lesson", "way", "outcome", "iou", "next pose"}, {}};
  Tally of_way[4];
  for (int i = 0; i < lessons; ++i) {
    cv::RNG random(static_cast<std::uint64_t>(100003 * seed + i));
    const Way way = static_cast<Way>(i % 4);
    Cell cell(static_cast<std::uint64_t>(1000 * seed + i), random);
    std::vector<std::string> row{std::to_string(i), kWayNames[i % 4]};
    const Outcome outcome = Demo(cell, way, random).run();
    judge(cell, outcome, of_way[i % 4], row);
    cases.rows.push_back(row);
  }
  Table table{{"way", "lessons", "stored rightly", "stored wrongly", "refused", "timed out",
               "median IoU", "5 % IoU"},
              {}};
  Tally all;
  for (int k = 0; k < 4; ++k) {
    table.rows.push_back(row_of(kWayNames[k], of_way[k]));
    all.lessons += of_way[k].lessons;
    all.right += of_way[k].right;
    all.wrong += of_way[k].wrong;
    all.refused += of_way[k].refused;
    all.late += of_way[k].late;
    all.ious.insert(all.ious.end(), of_way[k].ious.begin(), of_way[k].ious.end());
  }
  table.rows.push_back(row_of("all", all));
  save_csv((out / "lessons.csv").string(), cases);
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "lesson_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
