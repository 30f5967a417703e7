// SPDX-License-Identifier: BSD-3-Clause
// Whole stages on a simulated image, together with the OpenCV calls that serve as reference.
#include <benchmark/benchmark.h>

#include <memory>

#include "common/yardstick.hpp"
#include "imaging/pyramid.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/matching/similarity.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {
namespace {

/// One object with the images of its lesson and of a later scene.
struct Cell {
  explicit Cell(double diameter) {
    const sim::Scene scene;
    placed.object.diameter = diameter;
    placed.pose = {320, 240, 0};
    before = scene.render({placed}, 1);
    after = scene.render({}, 2);
    map = scene.true_map(placed);
    target = scene.render({{placed.object, {400, 200, 1}}}, 3);
  }

  Lesson lesson() const {
    Lesson lesson;
    lesson.name = "object";
    lesson.before = before;
    lesson.after = after;
    return lesson;
  }

  Matcher matcher(SearchConfig config = {}) const {
    auto model = std::make_shared<ObjectModel>();
    model->name = "object";
    const cv::Point2d reference = centroid(map);
    model->views.push_back(crop_view(before, map, {reference.x, reference.y, 0}));
    Matcher matcher(std::move(config));
    matcher.set_objects({std::move(model)});
    return matcher;
  }

  sim::Placed placed;
  cv::Mat before, after, map, target;
};

void yardstick_match(benchmark::State& state) {
  MatchYardstick yardstick;
  for (auto _ : state) yardstick.run();
}

void yardstick_cut(benchmark::State& state) {
  CutYardstick yardstick;
  for (auto _ : state) yardstick.run();
}

void pyramid(benchmark::State& state) {
  const Cell cell(90);
  for (auto _ : state) benchmark::DoNotOptimize(imaging::build_pyramid(cell.target, 3));
}

void similarity_at_a_pose(benchmark::State& state) {
  const Cell cell(static_cast<double>(state.range(0)));
  const std::vector<cv::Mat> channels = [&] {
    std::vector<cv::Mat> split;
    cv::split(cell.target, split);
    return split;
  }();
  const auto points = masked_template(channels[1], cell.map, centroid(cell.map));
  const Pose2D pose{400, 200, 1};
  for (auto _ : state) benchmark::DoNotOptimize(similarity(points, channels[1], pose));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

void prepare_object(benchmark::State& state) {
  const Cell cell(static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(cell.matcher());
}

void find_object(benchmark::State& state) {
  const Cell cell(static_cast<double>(state.range(0)));
  const Matcher matcher = cell.matcher();
  for (auto _ : state) benchmark::DoNotOptimize(matcher.find(cell.target));
}

void learn(benchmark::State& state, const std::string& method) {
  const Cell cell(static_cast<double>(state.range(0)));
  LearningConfig config;
  config.method = method;
  for (auto _ : state) benchmark::DoNotOptimize(learn_object(cell.lesson(), config));
}

BENCHMARK(yardstick_match)->Unit(benchmark::kMillisecond);
BENCHMARK(yardstick_cut)->Unit(benchmark::kMillisecond);
BENCHMARK(pyramid)->Unit(benchmark::kMicrosecond);
BENCHMARK(similarity_at_a_pose)->Arg(40)->Arg(160)->Unit(benchmark::kMicrosecond);
BENCHMARK(prepare_object)->Arg(40)->Arg(90)->Arg(160)->Unit(benchmark::kMillisecond);
BENCHMARK(find_object)->Arg(40)->Arg(90)->Arg(160)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(learn, change_cut, "change_cut")
    ->Arg(90)
    ->Arg(160)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(learn, sb_grabcut, "sb_grabcut")
    ->Arg(90)
    ->Arg(160)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mbncc::bench
