// SPDX-License-Identifier: BSD-3-Clause
// Images of changed scenes: nothing was taken away, the light was switched, or the camera was
// pushed. None of these lessons may store a map, unless the light was switched, a region shows the
// object and the map is correct.
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <opencv2/imgproc.hpp>

#include "common/case_folder.hpp"
#include "common/program.hpp"
#include "common/table.hpp"
#include "learning/map_score.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::bench {
namespace {

cv::Mat with_noise(const cv::Mat& image, double gain, cv::RNG& random) {
  cv::Mat values, noise(image.size(), CV_32FC3), result;
  image.convertTo(values, CV_32F, gain);
  random.fill(noise, cv::RNG::NORMAL, 0, 2.5);
  values += noise;
  values.convertTo(result, CV_8U);
  return result;
}

cv::Mat nothing_changed(const CaseFolder& one, cv::RNG& random) {
  return with_noise(one.before, random.uniform(0.97, 1.03), random);
}

// The object is removed and the light changes: darker, brighter, or from the other side.
cv::Mat light_switched(const CaseFolder& one, cv::RNG& random) {
  const double left = random.uniform(0.45, 0.75), right = random.uniform(1.3, 1.7);
  const int way = random.uniform(0, 3);
  if (way == 0) return with_noise(one.after, left * 0.9, random);
  if (way == 1) return with_noise(one.after, right * 1.15, random);
  cv::Mat ramp(1, 2, CV_32FC3), light, values, result;
  ramp.at<cv::Vec3f>(0, 0) = cv::Vec3f::all(static_cast<float>(left));
  ramp.at<cv::Vec3f>(0, 1) = cv::Vec3f::all(static_cast<float>(right));
  cv::resize(ramp, light, one.after.size(), 0, 0, cv::INTER_LINEAR);
  one.after.convertTo(values, CV_32F);
  cv::Mat(values.mul(light)).convertTo(result, CV_8U);
  return with_noise(result, 1, random);
}

cv::Mat camera_pushed(const CaseFolder& one, cv::RNG& random) {
  const double way = random.uniform(0.0, 2 * kPi), shift = random.uniform(14.0, 60.0);
  const double turn = random.uniform(-5.0, 5.0);
  const cv::Point2f centre(one.after.cols / 2.F, one.after.rows / 2.F);
  cv::Mat motion = cv::getRotationMatrix2D(centre, turn, 1), moved;
  motion.at<double>(0, 2) += shift * std::cos(way);
  motion.at<double>(1, 2) += shift * std::sin(way);
  cv::warpAffine(one.after, moved, motion, one.after.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return with_noise(moved, 1, random);
}

constexpr int kTries = 100;        // per disturbance
constexpr double kRightMap = 0.6;  // IoU

using Disturb = std::function<cv::Mat(const CaseFolder&, cv::RNG&)>;

// Leaves out cases with a change of exposure, because it could cancel the change of light.
std::vector<CaseFolder> evenly_exposed_cases(const std::vector<std::string>& sets) {
  std::vector<CaseFolder> cases;
  for (const auto& set : sets)
    for (const auto& name : list_cases(set)) {
      CaseFolder one = read_case(set + "/" + name);
      if (std::count(one.tags.begin(), one.tags.end(), "exposure") == 0) cases.push_back(one);
    }
  return cases;
}

void benchmark(const std::vector<std::string>& sets) {
  const std::vector<std::pair<std::string, Disturb>> ways{{"nothing changed", nothing_changed},
                                                          {"light switched", light_switched},
                                                          {"camera pushed", camera_pushed}};
  const auto cases = evenly_exposed_cases(sets);
  if (cases.empty()) throw std::runtime_error("the sets hold no case");
  Table table{{"disturbance", "region", "tries", "stored", "with a wrong map", "results"}, {}};
  for (const auto& [name, disturb] : ways)
    for (const bool with_region : {true, false}) {
      cv::RNG random(1);
      int stored = 0, wrong = 0;
      std::map<std::string, int> errors;
      for (int i = 0; i < kTries; ++i) {
        const CaseFolder& one = cases[i % cases.size()];
        Lesson lesson;
        lesson.name = "object";
        lesson.before = one.before;
        lesson.after = disturb(one, random);
        if (with_region) lesson.region = one.region;
        const LearnResult result = learn_object(lesson);
        if (result.error == LearnError::kSuccess) {
          ++stored;
          const cv::Mat map = full_size_map(result.object.views.front());
          wrong += score_map(map, one.map).iou < kRightMap;
        }
        ++errors[to_string(result.error)];
      }
      std::string results;
      for (const auto& [error, count] : errors)
        results += error + " " + std::to_string(count) + " ";
      table.rows.push_back({name, with_region ? "yes" : "no", std::to_string(kTries),
                            std::to_string(stored), std::to_string(wrong), results});
    }
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_on_sets(argc, argv, "refusals_bench", mbncc::bench::benchmark);
}
