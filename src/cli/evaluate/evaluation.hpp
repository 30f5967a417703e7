// SPDX-License-Identifier: BSD-3-Clause
// Compares detections with the truth.
#pragma once

#include <string>
#include <vector>

#include "cli/evaluate/truth.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::cli {

/// Largest errors of a right detection.
struct Tolerance {
  double place = 5;                ///< [px]
  double angle = to_radians(5.0);  ///< [rad], modulo symmetry
};

/// Of one image.
struct Comparison {
  std::vector<TrueInstance> missed;
  std::vector<Match> right, wrong;
  std::vector<double> place_errors, angle_errors;  ///< of the right ones [px], [rad]
};

/// Each true instance is matched with at most one detection, the best first.
Comparison compare(const std::vector<TrueInstance>& truth, const std::vector<Match>& matches,
                   const Tolerance& tolerance);

/// Of all images.
struct Figures {
  int images = 0, unreadable = 0, instances = 0;
  int right = 0, wrong = 0, right_graspable = 0, wrong_graspable = 0;
  std::vector<double> place_errors, angle_errors;  ///< [px], [rad]
  double seconds = 0;                              ///< of searching

  void add(const Comparison& comparison, double search_time);
  double recall() const;               ///< [0..1] of the instances, NaN without any
  double recall_graspable() const;     ///< the same for graspable detections
  double precision() const;            ///< [0..1] of the detections, NaN without any
  double precision_graspable() const;  ///< the same for graspable detections
};

/// The quantile `part` of the sorted values; NaN for none.
double quantile(std::vector<double> values, double part);

}  // namespace mbncc::cli
