// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scoring.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "common/statistics.hpp"

namespace mbncc::bench {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

double ratio(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : std::numeric_limits<double>::quiet_NaN();
}

struct Difference {
  double position, angle;
};

Difference difference(const Pose2D& pose, const Instance& instance) {
  return {cv::norm(pose.position() - instance.pose.position()),
          angle_distance(pose.theta, instance.pose.theta, instance.symmetry)};
}

double signed_turn(double a, double b, int symmetry) {
  return wrap_angle(symmetry * (a - b)) / symmetry;
}

/// Squared error weighted by the covariance that the engine states. The angle of a round object is
/// not judged.
std::optional<double> squared_error(const Found& found, const Instance& instance) {
  if (!found.covariance || instance.symmetry == 0) return {};
  const cv::Vec3d error(found.pose.x - instance.pose.x, found.pose.y - instance.pose.y,
                        signed_turn(found.pose.theta, instance.pose.theta, instance.symmetry));
  return error.dot(found.covariance->inv(cv::DECOMP_SVD) * error);
}

/// The nearest instance that satisfies `accepted`.
template <class Accepted>
std::optional<std::size_t> nearest(const Pose2D& pose, const std::vector<Instance>& instances,
                                   const Accepted& accepted) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Difference apart = difference(pose, instances[i]);
    if (!accepted(i, apart) || apart.position >= least) continue;
    best = i;
    least = apart.position;
  }
  return best;
}

Judged describe(const Found& found, const std::vector<Instance>& instances,
                std::optional<std::size_t> instance, bool correct) {
  Judged judged;
  judged.score = found.score;
  judged.correct = correct;
  judged.graspable = found.graspable;
  judged.instance = instance;
  if (!instance) return judged;
  const Difference apart = difference(found.pose, instances[*instance]);
  judged.position_error = apart.position;
  if (instances[*instance].symmetry != 0) judged.angle_error = apart.angle;
  judged.squared_error = squared_error(found, instances[*instance]);
  return judged;
}

bool contains(const std::vector<std::string>& tags, const std::string& tag) {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

}  // namespace

std::vector<Judged> judge(std::vector<Found> found, const std::vector<Instance>& instances,
                          double diameter, const Tolerance& tolerance) {
  const double reach = std::max(tolerance.position, tolerance.of_diameter * diameter);
  const auto within = [&](std::size_t, Difference apart) {
    return apart.position <= reach && apart.angle <= tolerance.angle;
  };
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.score > b.score; });
  std::set<std::size_t> taken;
  std::vector<Judged> result;
  for (const auto& one : found) {
    const auto free = nearest(one.pose, instances, [&](std::size_t i, Difference apart) {
      return within(i, apart) && taken.count(i) == 0;
    });
    if (free) taken.insert(*free);
    auto instance = free ? free : nearest(one.pose, instances, within);
    if (!instance)
      instance = nearest(one.pose, instances, [&](std::size_t, Difference apart) {
        return apart.position <= std::max(reach, diameter / 4);
      });
    result.push_back(describe(one, instances, instance, free.has_value()));
  }
  return result;
}

void Tally::add(const std::vector<Judged>& judged, std::size_t instances, double ms) {
  detections_.insert(detections_.end(), judged.begin(), judged.end());
  instances_ += static_cast<int>(instances);
  ms_.push_back(ms);
  if (instances > 0) return;
  ++absent_targets_;
  if (!judged.empty()) alarm_scores_.push_back(judged.front().score);
}

Figures Tally::figures(double threshold) const {
  Figures figures;
  figures.threshold = threshold;
  figures.instances = instances_;
  figures.absent_targets = absent_targets_;
  double loudest_alarm = kNone;
  for (const double score : alarm_scores_) {
    figures.alarms += score >= threshold;
    loudest_alarm = std::max(loudest_alarm, score);
  }
  std::vector<double> position_errors, angle_errors, squared_errors;
  int beyond_alarms = 0;
  for (const auto& detection : detections_) {
    if (detection.score < threshold) continue;
    figures.graspable += detection.graspable;
    figures.graspable_wrong += detection.graspable && !detection.correct;
    (detection.correct ? figures.correct : figures.wrong) += 1;
    if (!detection.correct) continue;
    beyond_alarms += detection.score > loudest_alarm;
    position_errors.push_back(detection.position_error);
    if (detection.angle_error) angle_errors.push_back(*detection.angle_error);
    if (detection.squared_error) squared_errors.push_back(*detection.squared_error);
  }
  figures.recall = ratio(figures.correct, instances_);
  figures.precision = ratio(figures.correct, figures.correct + figures.wrong);
  figures.f1 = ratio(2 * figures.correct, figures.correct + figures.wrong + instances_);
  figures.recall_without_alarm = ratio(beyond_alarms, instances_);
  figures.position_error = median(std::move(position_errors));
  figures.angle_error = median(std::move(angle_errors));
  figures.error_ratio = std::sqrt(mean(squared_errors) / 3);
  figures.error_ratio_p95 = std::sqrt(percentile(squared_errors, 95));
  figures.ms_median = median(ms_);
  figures.ms_p95 = percentile(ms_, 95);
  figures.ms_max = percentile(ms_, 100);
  return figures;
}

std::vector<Figures> Tally::curve() const {
  std::set<double, std::greater<>> scores;
  for (const auto& detection : detections_) scores.insert(detection.score);
  std::vector<Figures> curve;
  for (const double score : scores) curve.push_back(figures(score));
  return curve;
}

double Tally::best_threshold() const {
  const auto all = curve();
  const auto best = std::max_element(
      all.begin(), all.end(), [](const Figures& a, const Figures& b) { return a.f1 < b.f1; });
  return best == all.end() ? std::numeric_limits<double>::infinity() : best->threshold;
}

void TaggedTally::add(const std::vector<Judged>& judged, const Target& target, double ms) {
  std::set<std::string> tags(target.tags.begin(), target.tags.end());
  for (const auto& instance : target.instances)
    tags.insert(instance.tags.begin(), instance.tags.end());
  if (target.instances.empty()) tags.insert("absent");
  by_tag_["all"].add(judged, target.instances.size(), ms);
  for (const auto& tag : tags) {
    const auto counts = [&](std::size_t i) {
      return contains(target.tags, tag) || contains(target.instances[i].tags, tag);
    };
    std::size_t instances = 0;
    for (std::size_t i = 0; i < target.instances.size(); ++i) instances += counts(i);
    std::vector<Judged> concerned;
    std::copy_if(judged.begin(), judged.end(), std::back_inserter(concerned),
                 [&](const Judged& one) { return !one.instance || counts(*one.instance); });
    by_tag_[tag].add(concerned, instances, ms);
  }
}

}  // namespace mbncc::bench
