// SPDX-License-Identifier: BSD-3-Clause
// Compares detections with the true poses.
#pragma once

#include <string>
#include <vector>

#include "cli/evaluate/truth.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::cli {

/// Largest errors of a correct detection.
struct Tolerance {
  double place = 5;                ///< [px]
  double angle = to_radians(5.0);  ///< [rad], modulo symmetry
};

/// Result for one image.
struct Comparison {
  std::vector<TrueInstance> missed;
  std::vector<Match> right, wrong;
  std::vector<double> place_errors, angle_errors;  ///< of the correct ones [px], [rad]
};

/// Matches each true instance with at most one detection, the best detection first.
Comparison compare(const std::vector<TrueInstance>& truth, const std::vector<Match>& matches,
                   const Tolerance& tolerance);

/// Results summed over all images.
struct Figures {
  int images = 0, unreadable = 0, instances = 0;
  int right = 0, wrong = 0, right_graspable = 0, wrong_graspable = 0;
  std::vector<double> place_errors, angle_errors;  ///< [px], [rad]
  double seconds = 0;                              ///< of all searches

  void add(const Comparison& comparison, double search_time);
  double recall() const;               ///< [0..1] of the instances; NaN if there are none
  double recall_graspable() const;     ///< the same for graspable detections
  double precision() const;            ///< [0..1] of the detections; NaN if there are none
  double precision_graspable() const;  ///< the same for graspable detections
};

/// The quantile `part` [0..1] of the values; NaN if there are none.
double quantile(std::vector<double> values, double part);

}  // namespace mbncc::cli
