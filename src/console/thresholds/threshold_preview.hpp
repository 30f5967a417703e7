// SPDX-License-Identifier: BSD-3-Clause
// Preview of other thresholds in one image.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>

#include <string>
#include <vector>

#include "console/cell_settings.hpp"
#include "console/image/marks.hpp"

namespace mbncc::console {

class ThresholdPreview {
 public:
  ThresholdPreview() = default;
  /// `all`: all detections with minimal thresholds; `now`: the current thresholds.
  ThresholdPreview(const mbncc_vision::DetectedObjectArray& all, const Thresholds& now);

  /// The detections reported with the thresholds `wanted`, graspable ones as kGood.
  std::vector<Mark> marks(const Thresholds& wanted) const;

  /// "In this image: reported 3 (now 2), graspable 1 (now 1)."; `object`: counts only its
  /// detections, "": all.
  std::string summary(const Thresholds& wanted, const std::string& object = "") const;

  const Thresholds& now() const { return now_; }

 private:
  struct Counts {
    int reported = 0, graspable = 0;
  };
  Counts count(const Thresholds& thresholds, const std::string& object) const;
  static bool reported(const mbncc_vision::DetectedObject& object, const Thresholds& thresholds);
  static bool graspable(const mbncc_vision::DetectedObject& object, const Thresholds& thresholds);

  mbncc_vision::DetectedObjectArray all_;
  Thresholds now_;
};

}  // namespace mbncc::console
