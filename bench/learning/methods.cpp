#include <limits>

#include "common/clock.hpp"
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

/// A whole lesson by one of the package's methods; the map is ready when the verdict begins.
Cut lesson(const CaseFolder& one, const std::string& method, int iterations) {
  LearningConfig config;
  config.method = method;
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

Method package_method(const std::string& name) {
  return {name,
          [name](const CaseFolder& one, int iterations) { return lesson(one, name, iterations); }};
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> list = {
      package_method("change_cut"),
      package_method("sb_grabcut"),
      package_method("grabcut_mask"),
      package_method("grabcut_rect"),
      {"grabcut_scribbles", scribble_grabcut},
  };
  return list;
}

}  // namespace mbncc::bench
