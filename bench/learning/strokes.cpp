// One stroke of the operator on each map that misses the object (IoU below .85), drawn with the
// true map along the middle of the largest error.
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc.hpp>

#include "common/case_folder.hpp"
#include "common/clock.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "common/yardstick.hpp"
#include "learning/map_score.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc::bench {
namespace {

constexpr double kBad = 0.85;  // IoU below which an operator would correct
constexpr double kMiddle =
    0.4;  // of the error's greatest half-width: the stroke keeps to its middle
constexpr int kStrokeWidth = 3;  // [px]

cv::Mat largest_part(const cv::Mat& mask) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8, CV_32S);
  int largest = 1;
  for (int i = 2; i < count; ++i)
    if (stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(largest, cv::CC_STAT_AREA)) largest = i;
  return labels == largest;
}

// Dots of a pixel that make a stroke along the middle line of `part`, and no wider than it.
std::vector<LessonEdit::Line> stroke_on(const cv::Mat& part) {
  cv::Mat line, depth, stroke;
  cv::ximgproc::thinning(part, line);
  cv::distanceTransform(part, depth, cv::DIST_L2, 5);
  double deepest = 0;
  cv::minMaxLoc(depth, nullptr, &deepest);
  // Of a patch as wide as long, thinning may leave nothing: a dot in its middle.
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
  std::vector<double> before, after, again_ms, yardstick_ms;
  int worse = 0, restored = 0;
};

void run_case(const CaseFolder& one, Tally& tally) {
  Lesson lesson;
  lesson.name = "object";
  lesson.before = one.before;
  lesson.after = one.after;
  lesson.region = one.region;
  InteractiveLesson learned(lesson);
  if (!learned.result().has_model) return;
  const cv::Mat first = map_of(learned.result());
  const double before = score_map(first, one.map).iou;
  if (before >= kBad) return;
  CutYardstick yardstick;
  tally.yardstick_ms.push_back(cpu_ms_of([&] { yardstick.run(); }));
  const LessonEdit edit = correction(first, one.map);
  const double start = thread_cpu_ms();
  double again_ms = 0;
  const LearnResult result =
      learned.edit(edit, [&](Stage stage, double, const std::string&, const cv::Mat&) {
        if (stage == Stage::kQuality && again_ms == 0) again_ms = thread_cpu_ms() - start;
        return true;
      });
  const double after = result.has_model ? score_map(map_of(result), one.map).iou : before;
  tally.again_ms.push_back(again_ms);
  tally.before.push_back(before);
  tally.after.push_back(after);
  tally.worse += after < before;
  learned.undo();
  tally.restored += cv::norm(map_of(learned.result()), first, cv::NORM_INF) == 0;
}

void benchmark(const std::vector<std::string>& sets) {
  Table table{{"set", "maps below .85", "IoU", "after a stroke", "worse", "restored by undo",
               "again ms", "ratio"},
              {}};
  for (const auto& set : sets) {
    Tally tally;
    for (const auto& name : list_cases(set)) run_case(read_case(set + "/" + name), tally);
    table.rows.push_back({set, std::to_string(tally.before.size()), to_text(mean(tally.before), 3),
                          to_text(mean(tally.after), 3), std::to_string(tally.worse),
                          std::to_string(tally.restored), to_text(median(tally.again_ms), 1),
                          to_text(median(tally.again_ms) / median(tally.yardstick_ms), 2)});
  }
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_on_sets(argc, argv, "strokes_bench", mbncc::bench::benchmark);
}
