// SPDX-License-Identifier: BSD-3-Clause
// Compares detections with the truth and computes figures. A detection is correct if its position
// and angle are within the tolerance of an instance (angle modulo the object's symmetry). Instances
// are assigned greedily by score, and a second detection of an instance counts as wrong.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/case_folder.hpp"
#include "matching/engine.hpp"

namespace mbncc::bench {

struct Tolerance {
  double position = 3;           ///< [px] ...
  double of_diameter = 0.03;     ///< ... or this fraction of the object's diameter, if larger
  double angle = to_radians(3);  ///< [rad]
};

/// A detection and its verdict.
struct Judged {
  double score = 0;
  bool correct = false;
  bool graspable = false;
  std::optional<std::size_t> instance;  ///< the one that it found, found again or nearly found
  double position_error = 0;            ///< [px] to that instance
  std::optional<double> squared_error;  ///< [1] weighted by the stated covariance; 3 expected
  std::optional<double> angle_error;    ///< [rad] to that instance; none for round objects
};

/// Returns the detections in descending order of score.
std::vector<Judged> judge(std::vector<Found> found, const std::vector<Instance>& instances,
                          double diameter, const Tolerance& tolerance = {});

/// Figures of one engine on a set.
struct Figures {
  double threshold = 0;
  int instances = 0;
  int absent_targets = 0;
  int alarms = 0;  ///< absent targets with a detection
  int correct = 0;
  int wrong = 0;
  int graspable = 0;        ///< detections that the engine reports as graspable ...
  int graspable_wrong = 0;  ///< ... and that are not correct
  double recall = 0;
  double precision = 0;  ///< NaN without a detection
  double f1 = 0;
  double recall_without_alarm = 0;  ///< with the lowest threshold that gives no alarms
  double position_error = 0;        ///< [px] median of the correct ones
  double angle_error = 0;           ///< [rad] median of the correct ones
  double error_ratio = 0;           ///< [1] RMS error divided by the stated deviation, correct ones
  double error_ratio_p95 = 0;       ///< [1] 95th percentile of the Mahalanobis error; expected: 2.8
  double ms_median = 0, ms_p95 = 0, ms_max = 0;
};

/// All reports of one engine over many targets, with all scores.
class Tally {
 public:
  /// `judged` is the result of judge() for one target with `instances` instances; `ms` is the
  /// search time [ms].
  void add(const std::vector<Judged>& judged, std::size_t instances, double ms);

  Figures figures(double threshold) const;

  /// Figures at every threshold that makes a difference, in descending order.
  std::vector<Figures> curve() const;

  /// The threshold with the best F1 on the data that was added; it is optimistic, because it is
  /// chosen with the truth.
  double best_threshold() const;

 private:
  std::vector<Judged> detections_;
  std::vector<double> alarm_scores_;  // best score in each absent target with a detection
  std::vector<double> ms_;
  int instances_ = 0;
  int absent_targets_ = 0;
};

/// Tallies for a whole set (tag "all") and for each tag of targets and instances.
class TaggedTally {
 public:
  void add(const std::vector<Judged>& judged, const Target& target, double ms);

  const Tally& all() const { return by_tag_.at("all"); }
  const std::map<std::string, Tally>& by_tag() const { return by_tag_; }

 private:
  std::map<std::string, Tally> by_tag_{{"all", {}}};
};

}  // namespace mbncc::bench
