// SPDX-License-Identifier: BSD-3-Clause
// Objects taught at one rotation and at several: do more views improve the results? The additional
// views are the first targets of a case, with the true map at the true pose; the remaining targets
// are searched.
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
#include "matching/scoring.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@sets    |       | comma separated: folders with the cases }"
    "{views    | 1,2,4 | comma separated: numbers of views; the largest tells what is searched }"
    "{help h   |       | this text }";

/// The object as it appears in a target; none if it is not completely in the image.
std::optional<View> view_in(const Target& target, const CaseFolder& one) {
  if (target.instances.size() != 1) return {};
  const Pose2D& pose = target.instances.front().pose;
  const cv::Mat image = read_image(target.image);
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  const cv::Point2d r = one.reference;
  const cv::Matx23d motion(c, -s, pose.x - c * r.x + s * r.y, s, c, pose.y - s * r.x - c * r.y);
  cv::Mat map;
  cv::warpAffine(one.map, map, motion, image.size());
  map = map > 127;
  if (cv::countNonZero(map) < 0.98 * cv::countNonZero(one.map)) return {};
  return crop_view(image, map, pose);
}

struct Lesson {
  std::vector<View> views;      ///< starting with the view of the lesson
  std::vector<Target> targets;  ///< targets that were not used as views
};

Lesson lesson_of(const CaseFolder& one, std::size_t most) {
  Lesson lesson;
  lesson.views.push_back(crop_view(one.before, one.map, {one.reference.x, one.reference.y, 0}));
  for (const auto& target : one.targets) {
    const auto view = lesson.views.size() < most ? view_in(target, one) : std::nullopt;
    if (view)
      lesson.views.push_back(*view);
    else
      lesson.targets.push_back(target);
  }
  return lesson;
}

struct Run {
  std::size_t views;
  Tally tally;
};

void run_case(const CaseFolder& one, std::vector<Run>& runs, std::vector<double>& yardstick_ms) {
  std::size_t most = 1;
  for (const auto& run : runs) most = std::max(most, run.views);
  const Lesson lesson = lesson_of(one, most);
  std::vector<Matcher> matchers;
  for (const auto& run : runs) {
    auto object = std::make_shared<ObjectModel>();
    object->name = "object";
    const std::size_t count = std::min(run.views, lesson.views.size());
    object->views.assign(lesson.views.begin(),
                         lesson.views.begin() + static_cast<std::ptrdiff_t>(count));
    matchers.emplace_back();
    matchers.back().set_objects({std::move(object)});
  }
  MatchYardstick yardstick;
  for (const auto& target : lesson.targets) {
    const cv::Mat image = read_image(target.image);
    yardstick_ms.push_back(cpu_ms_of([&] { yardstick.run(); }));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      SearchResult result;
      const double ms = cpu_ms_of([&] { result = matchers[i].find(image); });
      std::vector<Found> found;
      for (const auto& match : result.matches)
        found.push_back({match.pose, match.score, match.graspable, match.covariance});
      runs[i].tally.add(judge(std::move(found), target.instances, one.diameter),
                        target.instances.size(), ms);
    }
  }
}

void benchmark(const cv::CommandLineParser& options) {
  std::vector<Run> runs;
  for (const auto& views : split(options.get<std::string>("views"), ','))
    runs.push_back({std::stoul(views), {}});
  std::vector<double> yardstick_ms;
  for (const auto& set : split(options.get<std::string>("@sets"), ','))
    for (const auto& name : list_cases(set))
      run_case(read_case(fs::path(set) / name), runs, yardstick_ms);
  Table table{{"views", "n", "recall", "precision", "alarms", "graspable right", "pos px",
               "angle deg", "error/sigma", "ms median", "ms p95", "ratio"},
              {}};
  for (const auto& run : runs) {
    const Figures figures = run.tally.figures(SearchConfig{}.min_score);
    table.rows.push_back(
        {std::to_string(run.views), std::to_string(figures.instances), to_text(figures.recall, 3),
         to_text(figures.precision, 3),
         std::to_string(figures.alarms) + "/" + std::to_string(figures.absent_targets),
         std::to_string(figures.graspable - figures.graspable_wrong) + "/" +
             std::to_string(figures.graspable),
         to_text(figures.position_error, 3), to_text(to_degrees(figures.angle_error), 3),
         to_text(figures.error_ratio, 2), to_text(figures.ms_median, 2), to_text(figures.ms_p95, 1),
         to_text(figures.ms_median / median(yardstick_ms), 2)});
  }
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "views_bench", mbncc::bench::kOptions, "@sets",
                                   mbncc::bench::benchmark);
}
