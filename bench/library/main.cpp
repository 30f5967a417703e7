// SPDX-License-Identifier: BSD-3-Clause
// Many objects in one search: recall, precision and time for different numbers of objects and
// threads.
#include <sys/resource.h>

#include <filesystem>
#include <iostream>
#include <map>

#include "common/clock.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"
#include "library/variants.hpp"
#include "matching/scoring.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@set     |             | folder with the cases; all of them share their targets }"
    "{objects  | 40          | comma separated: numbers of objects in the library }"
    "{threads  | 1           | comma separated: numbers of threads }"
    "{targets  | 0           | use only the first N targets; 0: all }"
    "{red      | 1           | the targets' red channel is multiplied by this }"
    "{blue     | 1           | and their blue channel by this }"
    "{repeat   | 1           | larger images for their time: each target repeated N times across "
    "and down; the copies count as false }"
    "{help h   |             | this text }";

/// The images to search, and the true instances by target and object.
struct Scene {
  std::vector<cv::Mat> images;
  std::vector<std::map<std::string, std::vector<Instance>>> truth;
  std::map<std::string, double> diameters;
  std::vector<std::shared_ptr<const ObjectModel>> objects;
};

struct Totals {
  Tally tally;
  std::vector<double> cpu_ms, wall_ms, yardstick_ms;
  std::vector<std::vector<Match>> matches;  // per image
};

cv::Mat target_image(const fs::path& file, const cv::CommandLineParser& options) {
  const int times = options.get<int>("repeat");
  return cv::repeat(
      tinted(read_image(file), options.get<double>("red"), options.get<double>("blue")), times,
      times);
}

Scene read_scene(const cv::CommandLineParser& options) {
  const fs::path set = options.get<std::string>("@set");
  const auto most = options.get<std::size_t>("targets");
  Scene scene;
  for (const auto& name : list_cases(set)) {
    const CaseFolder one = read_case(set / name);
    scene.objects.push_back(object_of(one));
    scene.diameters[name] = one.diameter;
    scene.truth.resize(std::max(scene.truth.size(), one.targets.size()));
    for (std::size_t i = 0; i < one.targets.size(); ++i) {
      if (scene.images.size() == i && (most == 0 || i < most))
        scene.images.push_back(target_image(one.targets[i].image, options));
      scene.truth[i][name] = one.targets[i].instances;
    }
  }
  return scene;
}

/// The detections of every object are judged separately; all detections of synthetic objects are
/// wrong.
void judge_matches(const Scene& scene, std::size_t image, const std::vector<std::string>& names,
                   const std::vector<Match>& matches, double ms, Tally& tally) {
  std::map<std::string, std::vector<Found>> found;
  for (const auto& name : names) found[name];
  for (const auto& match : matches)
    found[match.name].push_back({match.pose, match.score, match.graspable, match.covariance});
  for (const auto& [name, own] : found) {
    const auto truth = scene.truth[image].find(name);
    const auto instances =
        truth == scene.truth[image].end() ? std::vector<Instance>{} : truth->second;
    const double diameter = instances.empty() ? 0 : scene.diameters.at(name);
    tally.add(judge(own, instances, diameter), instances.size(), ms);
  }
}

double process_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Totals run(const Scene& scene, std::size_t objects, int threads) {
  SearchConfig config;
  config.threads = threads;
  Matcher matcher(config);
  const auto library = library_of(scene.objects, objects);
  matcher.set_objects(library);
  std::vector<std::string> names;
  for (const auto& object : library) names.push_back(object->name);
  MatchYardstick yardstick;
  Totals totals;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    totals.yardstick_ms.push_back(cpu_ms_of([&] { yardstick.run(); }));
    const double start = process_cpu_ms();
    const SearchResult result = matcher.find(scene.images[i]);
    totals.cpu_ms.push_back(process_cpu_ms() - start);
    totals.wall_ms.push_back(1e3 * result.search_time);
    judge_matches(scene, i, names, result.matches, totals.cpu_ms.back(), totals.tally);
    totals.matches.push_back(result.matches);
  }
  return totals;
}

bool same(const std::vector<std::vector<Match>>& a, const std::vector<std::vector<Match>>& b) {
  const auto equal = [](const Match& one, const Match& other) {
    return one.name == other.name && one.pose.x == other.pose.x && one.pose.y == other.pose.y &&
           one.pose.theta == other.pose.theta && one.score == other.score;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const std::vector<Match>& one, const std::vector<Match>& other) {
                      return std::equal(one.begin(), one.end(), other.begin(), other.end(), equal);
                    });
}

std::string peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::to_string(usage.ru_maxrss / 1024);
}

void benchmark(const cv::CommandLineParser& options) {
  const Scene scene = read_scene(options);
  Table table{{"objects", "threads", "n", "recall", "precision", "graspable right", "cpu ms",
               "wall ms", "ratio", "same as before", "peak MB"},
              {}};
  for (const auto& objects : split(options.get<std::string>("objects"), ',')) {
    std::vector<std::vector<Match>> before;
    for (const auto& threads : split(options.get<std::string>("threads"), ',')) {
      Totals totals = run(scene, std::stoul(objects), std::stoi(threads));
      const Figures figures = totals.tally.figures(SearchConfig{}.min_score);
      table.rows.push_back({objects, threads, std::to_string(figures.instances),
                            to_text(figures.recall, 3), to_text(figures.precision, 3),
                            std::to_string(figures.graspable - figures.graspable_wrong) + "/" +
                                std::to_string(figures.graspable),
                            to_text(median(totals.cpu_ms), 1), to_text(median(totals.wall_ms), 1),
                            to_text(median(totals.cpu_ms) / median(totals.yardstick_ms), 2),
                            before.empty()                 ? "-"
                            : same(before, totals.matches) ? "yes"
                                                           : "NO",
                            peak_memory()});
      before = std::move(totals.matches);
    }
  }
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "library_bench", mbncc::bench::kOptions, "@set",
                                   mbncc::bench::benchmark);
}
