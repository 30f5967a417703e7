// SPDX-License-Identifier: BSD-3-Clause
// Settings of Matcher::find.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct SearchConfig {
  std::string engine =
      "fast";  ///< fast: pyramid and rotated templates; polar: the paper's, step by step
  std::string accept_by =
      "score";             ///< score: probability from all features; similarity: the paper's rule
  double min_score = 0.5;  ///< [0..1] minimum score of a reported detection
  double confirm_score = 0.7;      ///< [0..1] minimum score of a graspable detection, see fields()
  double min_margin_place = 6;     ///< log-odds difference to the best competitor elsewhere
  double min_margin_angle = 6;     ///< log-odds difference to the best other angle at the place
  double max_place_deviation = 2;  ///< [px] largest standard deviation of a graspable position
  double max_angle_deviation = 1.5;  ///< [deg] largest standard deviation of a graspable angle
  double min_visible = 0.6;          ///< [0..1] part of the map inside the image
  int max_instances = 50;            ///< per name
  double max_overlap =
      0.25;  ///< [0..1] of the smaller map, above which the weaker detection is dropped
  double scale_range = 0;  ///< [0..0.5] largest relative difference in size that is searched
  double time_budget = 0;  ///< [s] per image; 0: none
  int threads = 1;         ///< worker threads of a search

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(
        FieldInfo{
            "engine", Allowed::one_of({"fast", "polar"}), "",
            "fast: image pyramid and rotated templates; polar: the paper's polar matching, never "
            "graspable, because it compares no other angles"},
        self.engine);
    visit(FieldInfo{"accept_by", Allowed::one_of({"score", "similarity"}), "",
                    "value that the thresholds compare: the score or the similarity"},
          self.accept_by);
    visit(FieldInfo{"min_score", Allowed::range(0, 1), "", "minimum score of a reported detection"},
          self.min_score);
    visit(
        FieldInfo{
            "confirm_score", Allowed::range(0, 1), "",
            "minimum score of a graspable detection; its probability must always be at least .98"},
        self.confirm_score);
    visit(FieldInfo{"min_margin_place", Allowed::range(0, 100), "log-odds",
                    "graspable only with this margin to the best competitor elsewhere"},
          self.min_margin_place);
    visit(FieldInfo{"min_margin_angle", Allowed::range(0, 100), "log-odds",
                    "graspable only with this margin to the best other angle at the place"},
          self.min_margin_angle);
    visit(
        FieldInfo{"max_place_deviation", Allowed::range(0, 100), "px",
                  "graspable only up to this standard deviation of the position in any direction"},
        self.max_place_deviation);
    visit(FieldInfo{"max_angle_deviation", Allowed::range(0, 180), "deg",
                    "graspable only up to this standard deviation of the angle"},
          self.max_angle_deviation);
    visit(FieldInfo{"min_visible", Allowed::range(0.1, 1), "",
                    "graspable only with this part of the map inside the image"},
          self.min_visible);
    visit(FieldInfo{"max_instances", Allowed::range(1, 1000), "", "detections per name and image"},
          self.max_instances);
    visit(FieldInfo{"max_overlap", Allowed::range(0, 1), "",
                    "overlap of two maps, as part of the smaller one, above which the weaker "
                    "detection is dropped"},
          self.max_overlap);
    visit(FieldInfo{"scale_range", Allowed::range(0, 0.5), "",
                    "largest relative difference in size that is searched; up to 3 % needs no "
                    "additional pass, every further 6 % adds two (smaller and larger)"},
          self.scale_range);
    visit(
        FieldInfo{
            "time_budget", Allowed::range(0, 3600), "s",
            "search time per image, after which the remaining objects are skipped; 0: no limit"},
        self.time_budget);
    visit(FieldInfo{"threads", Allowed::range(1, 256), "", "worker threads of a search"},
          self.threads);
  }
};

}  // namespace mbncc
