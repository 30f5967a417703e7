// SPDX-License-Identifier: BSD-3-Clause
// Live lessons in the simulated cell: an operator hesitates, reaches in, pauses, or first puts
// objects down or aside, under flickering and drifting light. Counts how many lessons are stored,
// and how good they are.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cell/demo.hpp"
#include "cell/lesson_cell.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@out    |     | folder for lessons.csv }"
    "{lessons | 100 | number of lessons }"
    "{seed    | 1   | random seed }"
    "{help h  |     | this text }";

constexpr double kLeastIou = 0.8, kMostShift = 2;  // [px]
constexpr double kMostTurn = to_radians(2);

const char* const kWayNames[] = {"taken away", "put aside", "already moved", "put down first"};

double iou(const cv::Mat& a, const cv::Mat& b) {
  return static_cast<double>(cv::countNonZero(a & b)) / std::max(1, cv::countNonZero(a | b));
}

/// Puts the object down at the next place and checks whether it is found there.
bool is_found_next(LessonCell& cell, const Outcome& outcome) {
  cell.finish_motion();
  cell.script().put_next();
  cell.finish_motion();
  Matcher matcher;
  matcher.set_objects({std::make_shared<ObjectModel>(outcome.learned.object)});
  const auto matches = matcher.find(cell.image()).matches;
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

void judge(LessonCell& cell, const Outcome& outcome, Tally& tally, std::vector<std::string>& row) {
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
    LessonCell cell(static_cast<std::uint64_t>(1000 * seed + i), random);
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
