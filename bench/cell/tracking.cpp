// SPDX-License-Identifier: BSD-3-Clause
// Identity of two equal objects that pass each other repeatedly at a distance of one width, with
// dropped images. Counts how often they are swapped, lost and confirmed.
#include <filesystem>
#include <iostream>
#include <map>

#include "common/program.hpp"
#include "common/table.hpp"
#include "mbncc/cell/tracker.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@out     |     | folder for tracking.csv }"
    "{runs     | 100 | runs of each condition }"
    "{images | 300 | of a run }"
    "{help h   |     | this text }";

constexpr double kRate = 30, kNoise = 0.3, kRadius = 40;  // [Hz], [px], [px]

struct Condition {
  double speed;   ///< [px] per image, for each object
  double missed;  ///< fraction of the images that is affected
  bool whole;     ///< whole images are dropped; otherwise one object is missed
};

struct Tally {
  int swaps = 0, identities = 0, seen = 0, confirmed = 0;
};

Match match_at(double x, double y) {
  Match match;
  match.name = "part";
  match.revision = 1;
  match.pose = {x, y, 0};
  match.score = 0.9;
  match.graspable = true;
  match.covariance = cv::Matx33d::eye() * (kNoise * kNoise);
  for (int k = 0; k < 16; ++k)
    match.outline.emplace_back(transform(match.pose, rotate({kRadius, 0}, 2 * kPi * k / 16)));
  return match;
}

void run(const Condition& condition, int images, std::uint64_t seed, Tally& tally) {
  cv::RNG random(seed);
  InstanceTracker tracker;
  std::map<std::uint32_t, int> owners;
  for (int i = 0; i < images; ++i) {
    const double phase = std::fmod(i * condition.speed, 600.);
    const double way = std::abs(phase - 300);  // there and back
    const bool dropped = random.uniform(0., 1.) < condition.missed;
    std::vector<Match> matches;
    std::vector<int> objects;
    for (const int object : {0, 1}) {
      if (!condition.whole && random.uniform(0., 1.) < condition.missed) continue;
      matches.push_back(match_at((object == 0 ? 100 + way : 400 - way) + random.gaussian(kNoise),
                                 100 + 2 * kRadius * object + random.gaussian(kNoise)));
      objects.push_back(object);
    }
    if (condition.whole && dropped) continue;
    const auto tracked = tracker.update(i / kRate, matches);
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const auto owner = owners.emplace(tracked[k].instance_id, objects[k]).first;
      tally.swaps += owner->second != objects[k];
      tally.confirmed += tracked[k].state == TrackState::kConfirmed;
      ++tally.seen;
    }
  }
  tally.identities += static_cast<int>(owners.size());
}

void benchmark(const cv::CommandLineParser& options) {
  const std::filesystem::path out = output_folder(options.get<std::string>("@out"));
  const int runs = options.get<int>("runs"), images = options.get<int>("images");
  Table table{
      {"px an image", "missed", "of these", "runs", "swaps", "identities a run", "confirmed"}, {}};
  for (const double speed : {0., 5., 10.})
    for (const double missed : {0., 0.2, 0.4})
      for (const bool whole : {true, false}) {
        if (missed == 0 && !whole) continue;
        Tally tally;
        for (int i = 1; i <= runs; ++i)
          run({speed, missed, whole}, images, static_cast<std::uint64_t>(i), tally);
        table.rows.push_back({to_text(speed, 0), to_text(missed, 1),
                              whole ? "whole images" : "single objects", std::to_string(runs),
                              std::to_string(tally.swaps),
                              to_text(static_cast<double>(tally.identities) / runs, 2),
                              to_text(static_cast<double>(tally.confirmed) / tally.seen, 3)});
      }
  save_csv((out / "tracking.csv").string(), table);
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "tracking_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
