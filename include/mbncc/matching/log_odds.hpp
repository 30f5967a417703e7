// SPDX-License-Identifier: BSD-3-Clause
// The named terms that add up to the log-odds of a detection.
#pragma once

#include <cmath>

namespace mbncc {

/// Log-odds that an object lies at a pose. Terms are added to `evidence` or subtracted from it, as
/// their comments state.
struct LogOdds {
  double evidence = 0;  ///< of the features at the pose (docs/decisions/0019-evidence-model.md)
  double colour = 0;    ///< subtracted: a part has another colour (0023)
  double mirror = 0;    ///< subtracted: the mirrored outline fits better (0024)
  double print = 0;     ///< subtracted: the print inside the outline differs (0023)
  double best_at_place = 0;  ///< of_pose() of the best rotation at this place (0022)
  double resized = 0;        ///< part of best_at_place gained by refining at another size (0032)
  double rotation = 0;       ///< subtracted: lead of the best rotation here over this one (0022)
  double clutter = 0;        ///< subtracted: similar places elsewhere, many searched objects (0028)
  double calibration = 0;    ///< added: margins, fit of the outline at nearby places (0028)

  /// Log-odds of the pose alone, without comparison with other detections.
  double of_pose() const { return evidence - colour - mirror - print; }
  /// Log-odds added by the comparison with the other rotations at the place.
  double rotations() const { return best_at_place - rotation - of_pose(); }
  /// Log-odds without calibration, comparable between detections in one image.
  double uncalibrated() const { return best_at_place - rotation - clutter; }
  /// uncalibrated() without the print penalty, because dirt, gloss or blur may hide a print.
  double without_print() const { return uncalibrated() + print; }
  /// Log-odds of `other` as a competitor of this detection. The print penalty of another object
  /// does not count. If this detection gained more by refinement at another size, the difference in
  /// gain does not count either, because which of two look-alikes reaches a size depends on where
  /// their refinements start. If `other` gained nothing, its colour and mirror penalties do not
  /// count, because they were measured at the wrong size.
  double of_competitor(const LogOdds& other, bool same_object) const {
    if (same_object) return other.uncalibrated();
    if (resized <= other.resized) return other.without_print();
    const double wrong_size = other.resized > 0 ? 0 : other.colour + other.mirror;
    return other.without_print() + resized - other.resized + wrong_size;
  }
  double total() const { return uncalibrated() + calibration; }
  /// [0..1] total() as a probability.
  double score() const { return 1 / (1 + std::exp(-total())); }
};

/// Log-odds of a pose that has not been compared with other detections.
inline LogOdds log_odds_of_pose(double evidence, double colour_penalty = 0,
                                double mirror_penalty = 0, double print_penalty = 0) {
  LogOdds odds;
  odds.evidence = evidence;
  odds.colour = colour_penalty;
  odds.mirror = mirror_penalty;
  odds.print = print_penalty;
  odds.best_at_place = odds.of_pose();
  return odds;
}

}  // namespace mbncc
