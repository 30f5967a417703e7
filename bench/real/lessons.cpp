// SPDX-License-Identifier: BSD-3-Clause
// Lessons from real photographs: every case in the given folders is taught in one way, and its map
// is compared with the true one. Writes figures per source, and maps and evidence for
// bench/real/page.py.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "common/case_folder.hpp"
#include "common/clock.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "learning/map_score.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@set       |        | folders that hold cases at any depth, comma separated }"
    "{by         | region | how the object is marked: region, none, click (with the image after);"
    " point (a click without it); region<percent>, box<percent> (with and without it; the true "
    "bounding box enlarged by so much); hand (the true map) }"
    "{method     | auto   | of learn_object; otsu, otsu_grabcut and opencv_grabcut: baselines }"
    "{half       |        | only sources of this half (SOURCE.json): tune or report; empty: all }"
    "{out        |        | folder for cases.csv and the maps }"
    "{help h     |        | this text }";

struct Way {
  std::string by;
  std::string method;
};

struct Outcome {
  cv::Mat map;  // CV_8UC1 of the image's size
  LearnResult result;
  double ms = 0;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> cases_below(const fs::path& root, const std::string& half) {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path folder = entry.path().parent_path();
    if (entry.path().filename() != "learn_before.png") continue;
    const std::string source = text_of(folder.parent_path() / "SOURCE.json");
    if (!half.empty() && source.find('"' + half + '"') == std::string::npos) continue;
    cases.push_back(folder);
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

cv::Point2f click_of(const CaseFolder& one) {
  const fs::path path = one.folder / "click.txt";
  cv::Point2f click;
  if (std::ifstream(path) >> click.x >> click.y) return click;
  cv::Mat distance;
  cv::distanceTransform(one.map, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Point innermost;
  cv::minMaxLoc(distance, nullptr, nullptr, nullptr, &innermost);
  return innermost;
}

cv::Rect enlarged(const cv::Rect& box, double percent, const cv::Size& image) {
  const int across = cvRound(box.width * percent / 200), down = cvRound(box.height * percent / 200);
  return cv::Rect(box.x - across, box.y - down, box.width + 2 * across, box.height + 2 * down) &
         cv::Rect({0, 0}, image);
}

Lesson lesson_of(const CaseFolder& one, const std::string& by) {
  Lesson lesson;
  lesson.name = "object";
  lesson.before = one.before;
  if (by == "hand") {
    lesson.map = one.map;
    return lesson;
  }
  const auto box = [&](std::size_t prefix) {
    return enlarged(cv::boundingRect(one.map), std::stod(by.substr(prefix)), one.map.size());
  };
  if (by.rfind("box", 0) == 0) {
    lesson.region = box(3);
    return lesson;
  }
  if (by == "click" || by == "point") lesson.click = click_of(one);
  if (by == "point") return lesson;
  lesson.after = one.after;
  if (by.rfind("region", 0) == 0) lesson.region = by == "region" ? one.region : box(6);
  return lesson;
}

// Otsu's threshold on the difference in the region, with the maximum over the channels; keeps the
// largest piece.
cv::Mat otsu_map(const Lesson& lesson) {
  const cv::Rect room =
      lesson.region.empty() ? cv::Rect({0, 0}, lesson.before.size()) : lesson.region;
  cv::Mat difference, channels[3], changed, labels, stats, centres;
  cv::absdiff(lesson.before(room), lesson.after(room), difference);
  cv::split(difference, channels);
  cv::threshold(cv::max(cv::max(channels[0], channels[1]), channels[2]), changed, 0, 255,
                cv::THRESH_BINARY | cv::THRESH_OTSU);
  const int count = cv::connectedComponentsWithStats(changed, labels, stats, centres);
  int largest = 0;
  for (int i = 1; i < count; ++i)
    if (largest == 0 ||
        stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(largest, cv::CC_STAT_AREA))
      largest = i;
  cv::Mat map = cv::Mat::zeros(lesson.before.size(), CV_8UC1);
  if (largest > 0) map(room).setTo(255, labels == largest);
  return map;
}

cv::Mat baseline(const Lesson& lesson, const std::string& method) {
  constexpr int kIterations = 5;
  if (method == "otsu") return otsu_map(lesson);
  if (method == "otsu_grabcut")
    return grabcut_mask(lesson.before, lesson.region, otsu_map(lesson), kIterations);
  cv::Mat labels, background, foreground;
  cv::setRNGSeed(0);
  cv::grabCut(lesson.before, labels, lesson.region, background, foreground, kIterations,
              cv::GC_INIT_WITH_RECT);
  return (labels & 1) * 255;
}

bool is_baseline(const std::string& method) {
  return method == "otsu" || method == "otsu_grabcut" || method == "opencv_grabcut";
}

Outcome teach(const CaseFolder& one, const Way& way) {
  const Lesson lesson = lesson_of(one, way.by);
  Outcome outcome;
  outcome.ms = cpu_ms_of([&] {
    if (is_baseline(way.method)) {
      outcome.map = baseline(lesson, way.method);
      return;
    }
    LearningConfig config;
    config.method = way.method;
    outcome.result = learn_object(lesson, config);
    if (outcome.result.has_model) outcome.map = full_size_map(outcome.result.object.views.front());
  });
  if (outcome.map.empty()) outcome.map = cv::Mat::zeros(one.map.size(), CV_8UC1);
  return outcome;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ";") + word;
  return text;
}

std::string verdict_of(const LearnResult& result) {
  return result.has_model ? to_string(result.object.quality.verdict) : to_string(result.error);
}

std::vector<std::string> row_of(const std::string& source, const CaseFolder& one,
                                const Outcome& outcome, const MapScore& score) {
  const Quality& quality = outcome.result.object.quality;
  const CutEvidence evidence = outcome.result.evidence.value_or(CutEvidence());
  std::vector<std::string> row{source, one.name, to_text(score.iou, 4),
                               to_text(score.boundary_f, 4), verdict_of(outcome.result)};
  for (const double value :
       {evidence.region_touch, evidence.change_outside, evidence.change_beside, evidence.stability,
        evidence.boundary_contrast, evidence.verified ? 1.0 : 0.0, evidence.region_span,
        quality.area, quality.edge_agreement, quality.self_score, quality.runner_up})
    row.push_back(to_text(value, 4));
  row.push_back(std::to_string(quality.symmetry));
  row.push_back(to_text(outcome.ms, 1));
  row.push_back(joined(quality.reasons));
  return row;
}

struct Figures {
  std::vector<double> iou, boundary_f, ms;
  std::map<std::string, int> verdicts;
  int low_stored = 0;
};

void note(const Outcome& outcome, const MapScore& score, Figures& figures) {
  figures.iou.push_back(score.iou);
  figures.boundary_f.push_back(score.boundary_f);
  figures.ms.push_back(outcome.ms);
  const std::string verdict = verdict_of(outcome.result);
  ++figures.verdicts[verdict == "GOOD" || verdict == "MARGINAL" || verdict == "BAD" ? verdict
                                                                                    : "refused"];
  if (score.iou < 0.6 && (verdict == "GOOD" || verdict == "MARGINAL")) ++figures.low_stored;
}

std::vector<std::string> summary_of(const std::string& name, const Figures& figures) {
  const auto verdicts = [&](const char* verdict) {
    const auto found = figures.verdicts.find(verdict);
    return std::to_string(found == figures.verdicts.end() ? 0 : found->second);
  };
  return {name,
          std::to_string(figures.iou.size()),
          to_text(mean(figures.iou), 3),
          to_text(median(figures.iou), 3),
          to_text(percentile(figures.iou, 0), 3),
          to_text(mean(figures.boundary_f), 3),
          verdicts("GOOD"),
          verdicts("MARGINAL"),
          verdicts("BAD"),
          verdicts("refused"),
          std::to_string(figures.low_stored),
          to_text(median(figures.ms), 0)};
}

std::vector<fs::path> chosen_cases(const cv::CommandLineParser& options) {
  std::vector<fs::path> cases;
  for (const auto& root : split(options.get<std::string>("@set"), ',')) {
    const auto below = cases_below(root, options.get<std::string>("half"));
    cases.insert(cases.end(), below.begin(), below.end());
  }
  if (cases.empty()) throw std::runtime_error("no folder with a learn_before.png found");
  return cases;
}

void benchmark(const cv::CommandLineParser& options) {
  const Way way{options.get<std::string>("by"), options.get<std::string>("method")};
  const fs::path out = output_folder(options.get<std::string>("out"));
  std::map<std::string, Figures> by_source;
  Figures all;
  Table cases{{"source", "case", "iou", "boundary_f", "verdict", "region_touch", "change_outside",
               "change_beside", "stability", "boundary_contrast", "verified", "region_span", "area",
               "edge_agreement", "self_score", "runner_up", "symmetry", "ms", "reasons"},
              {}};
  for (const fs::path& folder : chosen_cases(options)) {
    const CaseFolder one = read_case(folder);
    const std::string source = folder.parent_path().filename().string();
    const Outcome outcome = teach(one, way);
    const MapScore score = score_map(outcome.map, one.map);
    note(outcome, score, by_source[source]);
    note(outcome, score, all);
    cases.rows.push_back(row_of(source, one, outcome, score));
    if (!out.empty())
      cv::imwrite((out / (source + "__" + one.name + ".png")).string(), outcome.map);
  }
  Table table{{"source", "n", "IoU mean", "median", "min", "boundary F", "GOOD", "MARGINAL", "BAD",
               "refused", "stored below .6", "ms"},
              {}};
  for (const auto& [source, figures] : by_source) table.rows.push_back(summary_of(source, figures));
  table.rows.push_back(summary_of("all", all));
  write_markdown(std::cout, table);
  if (!out.empty()) save_csv((out / "cases.csv").string(), cases);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "real_lessons_bench", mbncc::bench::kOptions, "@set",
                                   mbncc::bench::benchmark);
}
