// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_preview.hpp"

#include <algorithm>

namespace mbncc::console {
namespace {

// The matcher's reason that depends on confirm_score.
constexpr const char* kScoreReason = "is below confirm_score";

}  // namespace

ThresholdPreview::ThresholdPreview(const mbncc_vision::DetectedObjectArray& all,
                                   const Thresholds& now)
    : all_(all), now_(now) {}

bool ThresholdPreview::reported(const mbncc_vision::DetectedObject& object,
                                const Thresholds& thresholds) {
  return object.score >= thresholds.min_score;
}

bool ThresholdPreview::graspable(const mbncc_vision::DetectedObject& object,
                                 const Thresholds& thresholds) {
  return reported(object, thresholds) && object.score >= thresholds.confirm_score &&
         std::all_of(object.reasons.begin(), object.reasons.end(), [](const std::string& reason) {
           return reason.find(kScoreReason) != std::string::npos;
         });
}

std::vector<Mark> ThresholdPreview::marks(const Thresholds& wanted) const {
  mbncc_vision::DetectedObjectArray shown;
  for (auto object : all_.objects) {
    if (!reported(object, wanted)) continue;
    object.state = graspable(object, wanted) ? mbncc_vision::DetectedObject::CONFIRMED
                                             : mbncc_vision::DetectedObject::NEW;
    shown.objects.push_back(object);
  }
  return marks_of(shown);
}

ThresholdPreview::Counts ThresholdPreview::count(const Thresholds& thresholds) const {
  Counts counts;
  for (const auto& object : all_.objects) {
    counts.reported += reported(object, thresholds) ? 1 : 0;
    counts.graspable += graspable(object, thresholds) ? 1 : 0;
  }
  return counts;
}

std::string ThresholdPreview::summary(const Thresholds& wanted) const {
  const Counts then = count(wanted), now = count(now_);
  return "In this picture: reported " + std::to_string(then.reported) + " (now " +
         std::to_string(now.reported) + "), graspable " + std::to_string(then.graspable) +
         " (now " + std::to_string(now.graspable) + ").";
}

}  // namespace mbncc::console
