// SPDX-License-Identifier: BSD-3-Clause
#include "cell/lesson_cell.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::bench {
namespace {

constexpr double kFrameTime = 0.1;                 // [s]
constexpr double kFlicker = 0.015, kDrift = 0.06;  // of the light

sim::SceneConfig scene_config(std::uint64_t seed) {
  sim::SceneConfig config;
  config.seed = seed;
  return config;
}

}  // namespace

LessonCell::LessonCell(std::uint64_t seed, cv::RNG& random)
    : random_(random), scene_(scene_config(seed)), script_(script_config(seed, random)) {
  drift_ = random.uniform(-kDrift, kDrift);
  phase_ = random.uniform(0., 2 * kPi);
}

void LessonCell::show(const std::optional<sim::Arm>& intruder) {
  const sim::CellFrame frame = script_.frame();
  const cv::Mat image = scene_.render(frame.placed, frames_, intruder ? intruder : frame.arm);
  const double t = static_cast<double>(frames_++);
  const double light =
      1 + drift_ * t / kPatience + kFlicker * std::sin(phase_ + 2.1 * t) + random_.gaussian(0.003);
  cv::Mat lit;
  image.convertTo(lit, -1, light);
  watch.update(1000 + kFrameTime * t, lit);
  script_.step();
}

void LessonCell::rest(int images) {
  for (int i = 0; i < images; ++i) show();
}

void LessonCell::finish_motion() {
  while (!script_.at_rest()) show();
}

void LessonCell::reach_in() {
  const cv::Point2d to(random_.uniform(100., 540.), random_.uniform(60., 400.));
  const int pause = random_.uniform(0, 12);
  for (int i = 0; i < 20 + pause; ++i) {
    const double share = std::min({1.0, i / 10.0, (19 + pause - i) / 10.0});
    const cv::Point2d from(to.x, 760);
    const cv::Point2d grip = from + (to - from) * share;
    show(sim::Arm{{grip.x, grip.y, -kPi / 2}});
  }
}

sim::CellScriptConfig LessonCell::script_config(std::uint64_t seed, cv::RNG& random) {
  sim::CellScriptConfig config;
  config.seed = seed;
  config.object = {seed, random.uniform(60., 130.), random.uniform(1.1, 2.5)};
  config.neighbours = random.uniform(0, 4);
  config.auto_play = false;
  config.leg_frames = random.uniform(6, 20);
  object_ = config.object;
  return config;
}

}  // namespace mbncc::bench
