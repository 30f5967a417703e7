// SPDX-License-Identifier: BSD-3-Clause
// Watching a simulated workshop with a library of taught objects, some of which lie in the image:
// cost of a still scene, of single changes and of a long video, and what is found in it.
#include <filesystem>
#include <iostream>
#include <optional>

#include "cell/workshop.hpp"
#include "common/clock.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@out    |      | folder for video.csv }"
    "{frames  | 3000 | images of the video }"
    "{objects | 40   | taught objects }"
    "{lying   | 12   | of these, in the image }"
    "{seed    | 1    | random seed of objects and story }"
    "{help h  |      | this text }";

constexpr double kDrift = 0.1, kFlicker = 0.015;  // of the light

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
  table.rows.push_back(cost_row("every image searched whole", whole, yardstick));
  table.rows.push_back(cost_row("still scene", still, yardstick));
}

/// Cost of `change`, which is applied to the first object, in the images until no search is
/// pending.
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

struct Tally {
  int visible = 0, found = 0, reported = 0, right = 0, graspable = 0, graspable_right = 0;
  int longest = 0;  ///< longest time [images] for which a visible object was missed
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
  const std::filesystem::path out = output_folder(options.get<std::string>("@out"));
  const int lying = options.get<int>("lying"), objects = options.get<int>("objects");
  Workshop workshop(objects, lying, options.get<int>("seed"));
  const double yardstick = yardstick_ms();
  std::cout << "Yardstick " << to_text(yardstick, 1) << " ms.\n";
  Table costs{{"images", "n", "mean ms", "median ms", "99 % ms", "mean ratio", "median ratio",
               "99 % ratio"},
              {}};
  Table delays{{"one object", "median images until found", "most", "until graspable", "most"}, {}};
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
  save_csv((out / "video.csv").string(), costs);
  write_markdown(std::cout, costs);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "video_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
