// SPDX-License-Identifier: BSD-3-Clause
// Compares learning methods on the same lessons in the same run on one thread: agreement with the
// true map and time, for every number of graph cuts.
#include <filesystem>
#include <iostream>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "common/case_folder.hpp"
#include "common/clock.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"
#include "learning/map_score.hpp"
#include "learning/method.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@set       |   | folder with the cases to learn }"
    "{out        |   | folder for cases.csv, figures.csv and the maps }"
    "{methods    |   | comma separated, sb_grabcut_slic_4000 and the like too; empty: the usual }"
    "{iterations | 5 | numbers of graph cuts: 1, 2, ... up to this }"
    "{cases      | 0 | use only the first N cases; 0: all }"
    "{help h     |   | this text }";

/// Results of one method with one number of iterations.
struct Series {
  std::vector<double> iou, boundary_f, accuracy, map_ms, lesson_ms;
  int refused = 0;
};

struct Run {
  std::vector<Method> methods;
  int iterations = 1;
  std::map<std::pair<std::string, int>, Series> series;
  std::vector<double> yardstick_ms;
  Table cases{{"case", "method", "iterations", "iou", "boundary_f", "accuracy", "map_ms",
               "lesson_ms", "outcome"},
              {}};
};

std::vector<Method> chosen(const std::string& names) {
  std::vector<Method> result;
  for (const auto& name : names.empty() ? usual_methods() : split(names, ','))
    result.push_back(method_named(name));
  return result;
}

void note(const CaseFolder& one, const std::string& method, int iterations, const Cut& cut,
          Run& run) {
  const MapScore score = cut.map.empty() ? MapScore{} : score_map(cut.map, one.map);
  Series& series = run.series[{method, iterations}];
  series.iou.push_back(score.iou);
  series.boundary_f.push_back(score.boundary_f);
  series.accuracy.push_back(score.accuracy);
  series.map_ms.push_back(cut.map_ms);
  series.lesson_ms.push_back(cut.lesson_ms);
  series.refused += cut.map.empty();
  run.cases.rows.push_back({one.name, method, std::to_string(iterations), to_text(score.iou, 6),
                            to_text(score.boundary_f, 6), to_text(score.accuracy, 6),
                            to_text(cut.map_ms, 3), to_text(cut.lesson_ms, 3), cut.outcome});
}

void save_map(const fs::path& folder, const std::string& name, const cv::Mat& map) {
  fs::create_directories(folder);
  if (map.empty()) return;
  const std::string path = (folder / (name + ".png")).string();
  if (!cv::imwrite(path, map)) throw std::runtime_error("cannot write '" + path + "'");
}

void run_case(const CaseFolder& one, const fs::path& out, Run& run) {
  CutYardstick yardstick;
  run.yardstick_ms.push_back(cpu_ms_of([&] { yardstick.run(); }));
  for (int iterations = 1; iterations <= run.iterations; ++iterations) {
    for (const auto& method : run.methods) {
      const Cut cut = method.cut(one, iterations);
      note(one, method.name, iterations, cut, run);
      const std::string folder = method.name + "_" + std::to_string(iterations);
      if (!out.empty()) save_map(out / folder, one.name, cut.map);
    }
  }
}

Table table_of(const Run& run) {
  Table table;
  table.columns = {"method",     "iterations", "n",          "refused",  "IoU mean",
                   "IoU median", "IoU min",    "boundary F", "accuracy", "accuracy median",
                   "map ms",     "lesson ms",  "ratio"};
  const double yardstick = median(run.yardstick_ms);
  for (const auto& method : run.methods) {
    for (int iterations = 1; iterations <= run.iterations; ++iterations) {
      const Series& series = run.series.at({method.name, iterations});
      table.rows.push_back(
          {method.name, std::to_string(iterations), std::to_string(series.iou.size()),
           std::to_string(series.refused), to_text(mean(series.iou), 3),
           to_text(median(series.iou), 3), to_text(percentile(series.iou, 0), 3),
           to_text(mean(series.boundary_f), 3), to_text(mean(series.accuracy), 3),
           to_text(median(series.accuracy), 3), to_text(median(series.map_ms), 1),
           to_text(median(series.lesson_ms), 1), to_text(median(series.map_ms) / yardstick, 2)});
    }
  }
  return table;
}

void benchmark(const cv::CommandLineParser& options) {
  const fs::path set = options.get<std::string>("@set");
  const fs::path out = output_folder(options.get<std::string>("out"));
  const auto cases = list_cases(set, options.get<std::size_t>("cases"));
  Run run;
  run.methods = chosen(options.get<std::string>("methods"));
  run.iterations = options.get<int>("iterations");
  for (const auto& name : cases) {
    std::cerr << name << '\n';
    run_case(read_case(set / name), out, run);
  }
  const Table table = table_of(run);
  write_markdown(std::cout, table);
  std::cout << "\nyardstick (cv::grabCut, 2 iterations, 200x200): "
            << to_text(median(run.yardstick_ms), 1) << " ms\n";
  if (out.empty()) return;
  save_csv((out / "cases.csv").string(), run.cases);
  save_csv((out / "figures.csv").string(), table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "learning_bench", mbncc::bench::kOptions, "@set",
                                   mbncc::bench::benchmark);
}
