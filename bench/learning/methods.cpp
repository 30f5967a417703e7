// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "common/clock.hpp"
#include "common/csv.hpp"
#include "learning/method.hpp"
#include "learning/scribbles.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc::bench {
namespace {

Lesson lesson_of(const CaseFolder& one) {
  Lesson lesson;
  lesson.name = "object";
  lesson.before = one.before;
  lesson.after = one.after;
  lesson.region = one.region;
  return lesson;
}

/// A whole lesson with one of the package's methods; the map is ready when the verdict begins.
Cut lesson(const CaseFolder& one, LearningConfig config, int iterations) {
  config.iterations = iterations;
  Cut cut;
  const double start = thread_cpu_ms();
  const auto observer = [&](Stage stage, double, const std::string&, const cv::Mat&) {
    if (stage == Stage::kQuality && cut.map_ms == 0) cut.map_ms = thread_cpu_ms() - start;
    return true;
  };
  const LearnResult result = learn_object(lesson_of(one), config, {}, observer);
  cut.lesson_ms = thread_cpu_ms() - start;
  if (cut.map_ms == 0) cut.map_ms = cut.lesson_ms;
  if (result.has_model) cut.map = full_size_map(result.object.views.front());
  cut.outcome =
      result.has_model ? to_string(result.object.quality.verdict) : to_string(result.error);
  return cut;
}

Cut scribble_grabcut(const CaseFolder& one, int iterations) {
  Cut cut;
  cut.lesson_ms = std::numeric_limits<double>::quiet_NaN();
  cut.outcome = "-";
  cut.map = cv::Mat::zeros(one.before.size(), CV_8UC1);
  const cv::Mat labels = scribbled(one.map, one.region);
  const cv::Rect crop = grabcut_crop(one.region, one.before.size());
  cut.map_ms = cpu_ms_of([&] {
    repeatable_grabcut(one.before(crop), labels(crop), iterations).copyTo(cut.map(crop));
  });
  return cut;
}

Method lesson_method(const std::string& name, const LearningConfig& config) {
  return {name, [config](const CaseFolder& one, int iterations) {
            return lesson(one, config, iterations);
          }};
}

Method package_method(const std::string& name) {
  LearningConfig config;
  config.method = name;
  return lesson_method(name, config);
}

/// "sb_grabcut_slic_4000": SLIC with 4000 superpixels requested.
Method superpixel_method(const std::string& name) {
  const auto parts = split(name, '_');
  LearningConfig config;
  config.method = "sb_grabcut";
  config.superpixel_method = parts.at(2);
  config.superpixels = std::stoi(parts.at(3));
  return lesson_method(name, config);
}

}  // namespace

std::vector<std::string> usual_methods() {
  return {"change_cut",   "sb_grabcut_seeds_1600", "sb_grabcut_slic_1000", "sb_grabcut_slic_4000",
          "grabcut_mask", "grabcut_rect",          "grabcut_scribbles"};
}

Method method_named(const std::string& name) {
  if (name == "grabcut_scribbles") return {name, scribble_grabcut};
  if (name.rfind("sb_grabcut_", 0) == 0) return superpixel_method(name);
  return package_method(name);
}

}  // namespace mbncc::bench
