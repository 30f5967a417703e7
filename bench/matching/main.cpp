// SPDX-License-Identifier: BSD-3-Clause
// Compares matching engines on the same images in the same run, on one thread, with true maps.
#include <filesystem>
#include <iostream>
#include <opencv2/imgproc.hpp>

#include "common/case_folder.hpp"
#include "common/clock.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"
#include "matching/engine.hpp"
#include "matching/predictions.hpp"
#include "matching/scoring.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@set            |     | folder with the cases to search }"
    "{out             |     | folder for figures.csv, curves.csv and one folder of predictions per "
    "engine }"
    "{engines         |     | comma separated; all when empty }"
    "{cases           | 0   | use only the first N cases; 0: all }"
    "{tags            |     | print a table per tag as well }"
    "{position_tol    | 3   | [px] largest position error of a correct detection ... }"
    "{position_of_diameter | 0.03 | ... or this part of the object's diameter, if larger }"
    "{scale           | 1   | the targets are resized by this factor, the truth with them }"
    "{angle_tol       | 3   | [deg] largest angle error of a correct detection }"
    "{help h          |     | this text }";

/// One engine and its results so far.
struct Contestant {
  std::string name;
  std::unique_ptr<Engine> engine;
  TaggedTally tally;
  double threshold = 0;  ///< the shipped one, or the best one on the whole set
};

struct Run {
  std::vector<Contestant> contestants;
  std::vector<double> yardstick_ms;
};

Run contestants_for(const std::string& names) {
  Run run;
  for (const auto& name : names.empty() ? engine_names() : split(names, ','))
    run.contestants.push_back({name, make_engine(name), {}, 0});
  return run;
}

/// The true instances in a target resized by `scale`; pixel centres are at integers there, too.
std::vector<Instance> rescaled(std::vector<Instance> instances, double scale) {
  for (auto& instance : instances) {
    instance.pose.x = (instance.pose.x + 0.5) * scale - 0.5;
    instance.pose.y = (instance.pose.y + 0.5) * scale - 0.5;
  }
  return instances;
}

cv::Mat rescaled(const cv::Mat& image, double scale) {
  if (scale == 1) return image;
  cv::Mat result;
  cv::resize(image, result, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return result;
}

/// Engines and yardstick take turns on every image, so that a temporary slowdown of the machine
/// affects all of them.
void run_case(const CaseFolder& one, const Tolerance& tolerance, double scale, const fs::path& out,
              Run& run) {
  MatchYardstick yardstick;
  std::map<std::string, Predictions> predictions;
  for (auto& contestant : run.contestants)
    contestant.engine->teach(one.before, one.map, one.reference);
  for (const auto& target : one.targets) {
    const cv::Mat image = rescaled(read_image(target.image), scale);
    const auto instances = rescaled(target.instances, scale);
    run.yardstick_ms.push_back(cpu_ms_of([&] { yardstick.run(); }));
    for (auto& contestant : run.contestants) {
      std::vector<Found> found;
      const double ms = cpu_ms_of([&] { found = contestant.engine->find(image); });
      contestant.tally.add(judge(found, instances, scale * one.diameter, tolerance), target, ms);
      predictions[contestant.name].add(target.name, found, ms);
    }
  }
  if (out.empty()) return;
  for (const auto& [name, prediction] : predictions) prediction.save(out / name, one.name);
}

void set_thresholds(Run& run) {
  for (auto& contestant : run.contestants) {
    const auto shipped = contestant.engine->threshold();
    contestant.threshold = shipped ? *shipped : contestant.tally.all().best_threshold();
  }
}

std::vector<std::string> row_of(const Contestant& contestant, const Tally& tally,
                                double yardstick) {
  const Figures figures = tally.figures(contestant.threshold);
  const auto ms = [](double value) { return to_text(value, value < 10 ? 2 : 1); };
  return {contestant.name,
          contestant.engine->threshold() ? "shipped" : "best F1",
          to_text(figures.threshold, 3),
          std::to_string(figures.instances),
          to_text(figures.recall, 3),
          to_text(figures.precision, 3),
          to_text(figures.f1, 3),
          to_text(figures.recall_without_alarm, 3),
          std::to_string(figures.alarms) + "/" + std::to_string(figures.absent_targets),
          std::to_string(figures.graspable - figures.graspable_wrong) + "/" +
              std::to_string(figures.graspable),
          to_text(figures.position_error, 3),
          to_text(to_degrees(figures.angle_error), 3),
          to_text(figures.error_ratio, 2),
          ms(figures.ms_median),
          ms(figures.ms_p95),
          ms(figures.ms_max),
          to_text(figures.ms_median / yardstick, 2)};
}

Table table_of(const Run& run, const std::string& tag) {
  Table table;
  table.columns = {"engine",    "rule",      "threshold",   "n",         "recall",
                   "precision", "F1",        "R@0abs",      "alarms",    "graspable right",
                   "pos px",    "angle deg", "error/sigma", "ms median", "ms p95",
                   "ms max",    "ratio"};
  for (const auto& contestant : run.contestants) {
    const auto at = contestant.tally.by_tag().find(tag);
    if (at != contestant.tally.by_tag().end())
      table.rows.push_back(row_of(contestant, at->second, median(run.yardstick_ms)));
  }
  return table;
}

/// All tags one below the other, with the tag as the first column.
Table table_of_tags(const Run& run) {
  Table all;
  for (const auto& [tag, unused] : run.contestants.front().tally.by_tag()) {
    Table table = table_of(run, tag);
    table.columns.insert(table.columns.begin(), "tag");
    all.columns = table.columns;
    for (auto& row : table.rows) {
      row.insert(row.begin(), tag);
      all.rows.push_back(std::move(row));
    }
  }
  return all;
}

/// Recall and precision of every engine at every threshold.
Table table_of_curves(const Run& run) {
  Table table{{"engine", "threshold", "recall", "precision"}, {}};
  for (const auto& contestant : run.contestants)
    for (const auto& point : contestant.tally.all().curve())
      table.rows.push_back({contestant.name, to_text(point.threshold, 6), to_text(point.recall, 6),
                            to_text(point.precision, 6)});
  return table;
}

void benchmark(const cv::CommandLineParser& options) {
  const fs::path set = options.get<std::string>("@set");
  const fs::path out = output_folder(options.get<std::string>("out"));
  const Tolerance tolerance{options.get<double>("position_tol"),
                            options.get<double>("position_of_diameter"),
                            to_radians(options.get<double>("angle_tol"))};
  const auto cases = list_cases(set, options.get<std::size_t>("cases"));
  Run run = contestants_for(options.get<std::string>("engines"));
  for (const auto& name : cases) {
    std::cerr << name << '\n';
    run_case(read_case(set / name), tolerance, options.get<double>("scale"), out, run);
  }
  set_thresholds(run);
  write_markdown(std::cout, options.has("tags") ? table_of_tags(run) : table_of(run, "all"));
  std::cout << "\nyardstick (cv::matchTemplate 101x101 in 640x480): "
            << to_text(median(run.yardstick_ms), 2) << " ms\n";
  if (out.empty()) return;
  save_csv((out / "figures.csv").string(), table_of_tags(run));
  save_csv((out / "curves.csv").string(), table_of_curves(run));
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "matching_bench", mbncc::bench::kOptions, "@set",
                                   mbncc::bench::benchmark);
}
