// SPDX-License-Identifier: BSD-3-Clause
// Preview of other thresholds in one picture.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <string>
#include <vector>

#include "console/picture/marks.hpp"

namespace mbncc::console {

struct Thresholds {
  double min_score = 0.5, confirm_score = 0.7;
};

class ThresholdPreview {
 public:
  ThresholdPreview() = default;
  /// All detections with minimal thresholds, and the current thresholds.
  ThresholdPreview(const mbncc_vision::DetectedObjectArray& all, const Thresholds& now);

  /// The detections reported with the thresholds `wanted`, graspable ones as kGood.
  std::vector<Mark> marks(const Thresholds& wanted) const;

  /// "Reported: 3 (now 2), graspable: 1 (now 1)".
  std::string summary(const Thresholds& wanted) const;

  const Thresholds& now() const { return now_; }

 private:
  struct Counts {
    int reported = 0, graspable = 0;
  };
  Counts count(const Thresholds& thresholds) const;
  static bool reported(const mbncc_vision::DetectedObject& object, const Thresholds& thresholds);
  static bool graspable(const mbncc_vision::DetectedObject& object, const Thresholds& thresholds);

  mbncc_vision::DetectedObjectArray all_;
  Thresholds now_;
};

}  // namespace mbncc::console
