// SPDX-License-Identifier: BSD-3-Clause
// Runs engines on a set and on the sets that shift.py made from it: one row per kind of shift and
// engine.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "common/case_folder.hpp"
#include "common/clock.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "common/table.hpp"
#include "matching/engine.hpp"
#include "matching/scoring.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@sets           |     | comma separated folders with a folder of cases per kind of shift }"
    "{out             |     | folder for counts.csv: what each engine found in each case }"
    "{engines         | ours | comma separated; all when empty }"
    "{kinds           |     | comma separated; all when empty }"
    "{help h          |     | this text }";

std::vector<std::string> kinds_in(const fs::path& set) {
  std::vector<std::string> kinds;
  for (const auto& entry : fs::directory_iterator(set))
    if (entry.is_directory()) kinds.push_back(entry.path().filename().string());
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

struct Contestant {
  std::string name;
  std::unique_ptr<Engine> engine;
  Tally all;
};

/// Adds the counts of one case, for paired comparisons.
void add_counts(const std::string& kind, const std::string& name, const std::string& engine,
                const Tally& tally, double threshold, Table& counts) {
  const Figures figures = tally.figures(threshold);
  counts.rows.push_back({kind, name, engine, std::to_string(figures.instances),
                         std::to_string(figures.correct), std::to_string(figures.wrong),
                         std::to_string(figures.graspable - figures.graspable_wrong),
                         std::to_string(figures.graspable_wrong), to_text(figures.ms_median, 3)});
}

void run_case(const fs::path& folder, const std::string& kind, std::vector<Contestant>& contestants,
              Table& counts) {
  const CaseFolder one = read_case(folder);
  std::vector<Tally> own(contestants.size());
  for (auto& contestant : contestants) contestant.engine->teach(one.before, one.map, one.reference);
  for (const auto& target : one.targets) {
    const cv::Mat image = read_image(target.image);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      std::vector<Found> found;
      const double ms = cpu_ms_of([&] { found = contestants[i].engine->find(image); });
      const auto judged = judge(found, target.instances, one.diameter);
      contestants[i].all.add(judged, target.instances.size(), ms);
      own[i].add(judged, target.instances.size(), ms);
    }
  }
  for (std::size_t i = 0; i < contestants.size(); ++i)
    add_counts(kind, folder.string(), contestants[i].name, own[i],
               contestants[i].engine->threshold().value_or(0), counts);
}

std::vector<std::string> row_of(const std::string& kind, const Contestant& contestant) {
  const auto shipped = contestant.engine->threshold();
  const Figures figures =
      contestant.all.figures(shipped ? *shipped : contestant.all.best_threshold());
  return {kind,
          contestant.name,
          std::to_string(figures.instances),
          to_text(figures.recall, 3),
          to_text(figures.precision, 3),
          std::to_string(figures.graspable - figures.graspable_wrong),
          std::to_string(figures.graspable_wrong),
          to_text(figures.error_ratio_p95, 2),
          to_text(figures.ms_median, 2),
          to_text(figures.ms_p95, 2)};
}

void benchmark(const cv::CommandLineParser& options) {
  const auto sets = split(options.get<std::string>("@sets"), ',');
  const fs::path out = output_folder(options.get<std::string>("out"));
  const auto chosen = options.get<std::string>("kinds");
  const auto engines = options.get<std::string>("engines");
  Table table{{"shift", "engine", "n", "recall", "precision", "graspable right", "graspable wrong",
               "error/sigma p95", "ms median", "ms p95"},
              {}};
  Table counts{
      {"kind", "case", "engine", "n", "found", "wrong", "graspable right", "graspable wrong", "ms"},
      {}};
  for (const auto& kind : chosen.empty() ? kinds_in(sets.front()) : split(chosen, ',')) {
    std::cerr << kind << '\n';
    std::vector<Contestant> contestants;
    for (const auto& name : engines.empty() ? engine_names() : split(engines, ','))
      contestants.push_back({name, make_engine(name), {}});
    for (const auto& set : sets)
      for (const auto& name : list_cases(fs::path(set) / kind, 0))
        run_case(fs::path(set) / kind / name, kind, contestants, counts);
    for (const auto& contestant : contestants) table.rows.push_back(row_of(kind, contestant));
  }
  write_markdown(std::cout, table);
  if (!out.empty()) save_csv((out / "counts.csv").string(), counts);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "shifts_bench", mbncc::bench::kOptions, "@sets",
                                   mbncc::bench::benchmark);
}
