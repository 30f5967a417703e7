// SPDX-License-Identifier: BSD-3-Clause
// Successive strokes of an operator on each map that misses the object (IoU below .85). Each stroke
// is drawn from the true map, along the middle of the largest error.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc.hpp>

#include "common/case_folder.hpp"
#include "common/clock.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"
#include "learning/map_score.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@sets    |       | comma separated: folders with the cases }"
    "{strokes  | 1     | on each map, one after the other }"
    "{out      |       | folder for strokes.csv: the IoU of each map after each stroke }"
    "{help h   |       | this text }";

constexpr double kBad = 0.85;  // IoU below which an operator would correct
// Of the error's largest half width: the stroke stays in its middle
constexpr double kMiddle = 0.4;
constexpr int kStrokeWidth = 3;  // [px]

cv::Mat largest_part(const cv::Mat& mask) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8, CV_32S);
  int largest = 1;
  for (int i = 2; i < count; ++i)
    if (stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(largest, cv::CC_STAT_AREA)) largest = i;
  return labels == largest;
}

// One-pixel dots that form a stroke along the middle line of `part` and no wider than it.
std::vector<LessonEdit::Line> stroke_on(const cv::Mat& part) {
  cv::Mat line, depth, stroke;
  cv::ximgproc::thinning(part, line);
  cv::distanceTransform(part, depth, cv::DIST_L2, 5);
  double deepest = 0;
  cv::minMaxLoc(depth, nullptr, &deepest);
  // Thinning may leave nothing of a compact patch; then its middle is used.
  if (cv::countNonZero(line) == 0) line = depth >= deepest;
  cv::dilate(line & (depth >= std::max(1.0, kMiddle * deepest)), stroke,
             cv::Mat::ones(kStrokeWidth, kStrokeWidth, CV_8U));
  std::vector<cv::Point> pixels;
  cv::findNonZero(stroke & part, pixels);
  std::vector<LessonEdit::Line> dots;
  for (const auto& pixel : pixels) dots.push_back({cv::Point2f(pixel)});
  return dots;
}

LessonEdit correction(const cv::Mat& map, const cv::Mat& truth) {
  const cv::Mat missing = truth & ~map, wrong = map & ~truth;
  const cv::Mat part = largest_part(missing | wrong);
  LessonEdit edit;
  edit.stroke_width = 1;
  const bool include = cv::countNonZero(part & missing) > cv::countNonZero(part & wrong);
  (include ? edit.include : edit.exclude) = stroke_on(part);
  return edit;
}

cv::Mat map_of(const LearnResult& result) {
  return full_size_map(result.object.views.front());
}

struct Tally {
  std::vector<std::vector<double>> ious;  // of each map: before the strokes, and after each one
  std::vector<double> again_ms, yardstick_ms;
  int restored = 0;
};

/// Carries out the edit; returns the thread CPU time [ms] until the new map is available.
double cpu_ms_of_edit(InteractiveLesson& lesson, const LessonEdit& edit) {
  const double start = thread_cpu_ms();
  double ms = 0;
  lesson.edit(edit, [&](Stage stage, double, const std::string&, const cv::Mat&) {
    if (stage == Stage::kQuality && ms == 0) ms = thread_cpu_ms() - start;
    return true;
  });
  return ms;
}

/// The IoU after each stroke; a lesson that fails keeps its last IoU.
std::vector<double> correct(InteractiveLesson& lesson, const cv::Mat& truth, int strokes,
                            std::vector<double>& again_ms) {
  std::vector<double> ious{score_map(map_of(lesson.result()), truth).iou};
  for (int i = 0; i < strokes; ++i) {
    if (!lesson.result().has_model) return ious;
    const LessonEdit edit = correction(map_of(lesson.result()), truth);
    again_ms.push_back(cpu_ms_of_edit(lesson, edit));
    ious.push_back(lesson.result().has_model ? score_map(map_of(lesson.result()), truth).iou
                                             : ious.back());
  }
  return ious;
}

void run_case(const CaseFolder& one, int strokes, Tally& tally) {
  Lesson lesson;
  lesson.name = "object";
  lesson.before = one.before;
  lesson.after = one.after;
  lesson.region = one.region;
  InteractiveLesson learned(lesson);
  if (!learned.result().has_model) return;
  const cv::Mat first = map_of(learned.result());
  if (score_map(first, one.map).iou >= kBad) return;
  CutYardstick yardstick;
  tally.yardstick_ms.push_back(cpu_ms_of([&] { yardstick.run(); }));
  tally.ious.push_back(correct(learned, one.map, strokes, tally.again_ms));
  for (std::size_t i = 1; i < tally.ious.back().size(); ++i) learned.undo();
  tally.restored += cv::norm(map_of(learned.result()), first, cv::NORM_INF) == 0;
}

/// IoUs of all maps after `stroke` strokes; maps with fewer strokes count with their last IoU.
std::vector<double> after(const Tally& tally, std::size_t stroke) {
  std::vector<double> values;
  for (const auto& ious : tally.ious) values.push_back(ious[std::min(stroke, ious.size() - 1)]);
  return values;
}

std::vector<std::string> row_of(const std::string& set, std::size_t strokes, const Tally& tally) {
  const std::vector<double> before = after(tally, 0), first = after(tally, 1);
  int worse = 0;
  for (std::size_t i = 0; i < before.size(); ++i) worse += first[i] < before[i];
  std::vector<std::string> row{set, std::to_string(tally.ious.size()), to_text(mean(before), 3)};
  for (std::size_t i = 1; i <= strokes; ++i) row.push_back(to_text(mean(after(tally, i)), 3));
  row.insert(row.end(), {std::to_string(worse), std::to_string(tally.restored),
                         to_text(median(tally.again_ms), 1),
                         to_text(median(tally.again_ms) / median(tally.yardstick_ms), 2)});
  return row;
}

void add_rows(const std::string& set, const Tally& tally, Table& maps) {
  for (std::size_t map = 0; map < tally.ious.size(); ++map)
    for (std::size_t stroke = 0; stroke < tally.ious[map].size(); ++stroke)
      maps.rows.push_back(
          {set, std::to_string(map), std::to_string(stroke), to_text(tally.ious[map][stroke], 6)});
}

void benchmark(const cv::CommandLineParser& options) {
  const std::filesystem::path out = output_folder(options.get<std::string>("out"));
  const int strokes = std::max(1, options.get<int>("strokes"));
  Table table{{"set", "maps below .85", "IoU"}, {}}, maps{{"set", "map", "stroke", "IoU"}, {}};
  for (int i = 1; i <= strokes; ++i)
    table.columns.push_back("after " + std::to_string(i) + (i == 1 ? " stroke" : " strokes"));
  table.columns.insert(table.columns.end(), {"worse", "restored by undo", "again ms", "ratio"});
  for (const auto& set : split(options.get<std::string>("@sets"), ',')) {
    Tally tally;
    for (const auto& name : list_cases(set))
      run_case(read_case(std::filesystem::path(set) / name), strokes, tally);
    table.rows.push_back(row_of(set, static_cast<std::size_t>(strokes), tally));
    add_rows(set, tally, maps);
  }
  write_markdown(std::cout, table);
  if (!out.empty()) save_csv((out / "strokes.csv").string(), maps);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "strokes_bench", mbncc::bench::kOptions, "@sets",
                                   mbncc::bench::benchmark);
}
