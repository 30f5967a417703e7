// SPDX-License-Identifier: BSD-3-Clause
// Lessons in which the object is put aside within the view: its old and new place are
// distinguished, it is found again, and both views contribute to the map.
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "common/case_folder.hpp"
#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "learning/map_score.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::bench {
namespace {

constexpr int kTries = 200;          // attempts before a case is left out
constexpr int kClearance = 12;       // [px] between both places, and to the edge of the image
constexpr double kNearEnough = 3;    // [px]
constexpr double kTurnedEnough = 3;  // [degrees]

// A motion that moves the object to a free place in the image.
std::optional<Pose2D> free_motion(const CaseFolder& one, cv::RNG& random) {
  const cv::Size size = one.map.size();
  const double reach = one.diameter / 2 + kClearance;
  for (int i = 0; i < kTries && 2 * reach < std::min(size.width, size.height); ++i) {
    const Pose2D place{random.uniform(reach, size.width - reach),
                       random.uniform(reach, size.height - reach), random.uniform(-kPi, kPi)};
    const Pose2D old_place{one.reference.x, one.reference.y, 0};
    if (cv::norm(place.position() - old_place.position()) < one.diameter + kClearance) continue;
    return compose(place, inverse(old_place));
  }
  return std::nullopt;
}

// The image after, with the object pasted in at the place to which `motion` moves it.
cv::Mat pasted(const CaseFolder& one, const Pose2D& motion, cv::RNG& random) {
  const cv::Matx23d matrix = matrix_of(motion);
  cv::Mat object, cover, after, noise(one.after.size(), CV_32FC3);
  cv::warpAffine(one.before, object, matrix, one.after.size(), cv::INTER_CUBIC);
  cv::warpAffine(one.map, cover, matrix, one.after.size(), cv::INTER_LINEAR);
  cv::GaussianBlur(cover, cover, {}, 0.7);
  cv::cvtColor(cover, cover, cv::COLOR_GRAY2BGR);
  cover.convertTo(cover, CV_32F, 1 / 255.0);
  object.convertTo(object, CV_32F);
  random.fill(noise, cv::RNG::NORMAL, 0, 2);
  object += noise;
  one.after.convertTo(after, CV_32F);
  cv::Mat mixed = after + cover.mul(object - after), result;
  mixed.convertTo(result, CV_8U);
  return result;
}

struct Tally {
  int cases = 0, right_place = 0, found = 0, registered = 0, refined = 0;
  std::vector<double> iou, iou_without, position_error, angle_error;
};

double part(int some, int all) {
  return all == 0 ? 0 : static_cast<double>(some) / all;
}

double score_lesson(const LearnResult& result, const CaseFolder& one) {
  return result.has_model ? score_map(full_size_map(result.object.views.front()), one.map).iou : 0;
}

void note_pose(const LearnResult& result, const CaseFolder& one, const Pose2D& motion,
               Tally& tally) {
  if (!result.put_aside) return;
  ++tally.found;
  tally.refined += result.put_aside->refined;
  const Pose2D frame = result.object.views.front().reference, truth = compose(motion, frame);
  const double position = cv::norm(result.put_aside->pose.position() - truth.position());
  const double angle =
      to_degrees(angle_distance(result.put_aside->pose.theta, truth.theta, symmetry_of(one.tags)));
  if (position > kNearEnough || angle > kTurnedEnough) return;
  ++tally.registered;
  tally.position_error.push_back(position);
  tally.angle_error.push_back(angle);
}

void run_case(const CaseFolder& one, bool with_region, cv::RNG& random, Tally& tally) {
  const auto motion = free_motion(one, random);
  if (!motion) return;
  ++tally.cases;
  Lesson lesson;
  lesson.name = "object";
  lesson.before = one.before;
  lesson.after = one.after;
  lesson.region = one.region;
  tally.iou_without.push_back(score_lesson(learn_object(lesson), one));
  lesson.after = pasted(one, *motion, random);
  if (!with_region) lesson.region = {};
  const LearnResult result = learn_object(lesson);
  tally.iou.push_back(score_lesson(result, one));
  if (result.has_model) {
    const cv::Point2d centre = centroid(full_size_map(result.object.views.front()));
    tally.right_place += cv::norm(centre - one.reference) < one.diameter / 4;
  }
  note_pose(result, one, *motion, tally);
}

void add_row(const std::string& name, const Tally& tally, Table& table) {
  table.rows.push_back(
      {name, std::to_string(tally.cases), to_text(part(tally.right_place, tally.cases), 3),
       to_text(part(tally.found, tally.cases), 3), to_text(part(tally.registered, tally.cases), 3),
       std::to_string(tally.refined), to_text(median(tally.position_error), 2),
       to_text(median(tally.angle_error), 2), to_text(mean(tally.iou), 3),
       to_text(mean(tally.iou_without), 3)});
}

void benchmark(const std::vector<std::string>& sets) {
  Table table{{"set", "cases", "right place", "found", "registered", "refined", "px", "degrees",
               "IoU", "IoU gone"},
              {}};
  for (const auto& set : sets)
    for (const bool with_region : {true, false}) {
      cv::RNG random(1);
      Tally tally;
      for (const auto& name : list_cases(set))
        run_case(read_case(set + "/" + name), with_region, random, tally);
      add_row(set + (with_region ? "" : ", no region"), tally, table);
    }
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_on_sets(argc, argv, "put_aside_bench", mbncc::bench::benchmark);
}
