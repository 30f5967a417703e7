// SPDX-License-Identifier: BSD-3-Clause
// Judges detections against the truth and sums up. The rules: a detection is correct when place
// and angle lie within the tolerance of an instance (angle modulo the object's symmetry), instances
// are given away greedily by score, and a second detection of an instance is as wrong as any other.
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
  double of_diameter = 0.03;     ///< [1] ... or this part of the object's diameter, if larger
  double angle = to_radians(3);  ///< [rad]
};

/// A detection and what became of it.
struct Judged {
  double score = 0;
  bool correct = false;
  bool graspable = false;
  std::optional<std::size_t> instance;  ///< the one that it found, doubled or nearly found
  double position_error = 0;            ///< [px] to that instance
  std::optional<double> squared_error;  ///< [1] weighted by the claimed covariance; 3 expected
  std::optional<double> angle_error;    ///< [rad] to that instance; none for round objects
};

/// Best score first.
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
  int graspable = 0;        ///< detections that the engine vouches for ...
  int graspable_wrong = 0;  ///< ... and that are not correct
  double recall = 0;
  double precision = 0;  ///< NaN without a detection
  double f1 = 0;
  double recall_without_alarm = 0;  ///< with the threshold that silences all absent targets
  double position_error = 0;        ///< [px] median of the correct ones
  double angle_error = 0;           ///< [rad] median of the correct ones
  double error_ratio = 0;           ///< [1] RMS error by claimed deviation of the correct ones
  double error_ratio_p95 = 0;       ///< [1] 95th percentile of the Mahalanobis error; honest: 2.8
  double ms_median = 0, ms_p95 = 0, ms_max = 0;
};

/// Everything one engine reported over many targets, all scores kept.
class Tally {
 public:
  /// `judged` is what judge() made of one target with `instances` instances. [ms] of its search.
  void add(const std::vector<Judged>& judged, std::size_t instances, double ms);

  Figures figures(double threshold) const;

  /// Figures at every threshold that makes a difference, highest first.
  std::vector<Figures> curve() const;

  /// The threshold with the best F1 on what was added: it flatters, since it knows the answers.
  double best_threshold() const;

 private:
  std::vector<Judged> detections_;
  std::vector<double> alarm_scores_;  // best one of each absent target with a detection
  std::vector<double> ms_;
  int instances_ = 0;
  int absent_targets_ = 0;
};

/// Tallies of a set, as a whole (tag "all") and by the tags of targets and instances.
class TaggedTally {
 public:
  void add(const std::vector<Judged>& judged, const Target& target, double ms);

  const Tally& all() const { return by_tag_.at("all"); }
  const std::map<std::string, Tally>& by_tag() const { return by_tag_; }

 private:
  std::map<std::string, Tally> by_tag_{{"all", {}}};
};

}  // namespace mbncc::bench
