// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_preview.hpp"

#include <algorithm>

namespace mbncc::console {
namespace {

/// Whether the matcher gives this reason in this image with any confirm_score. The other reasons
/// are the score, other images and the age of this one.
bool stays(const std::string& reason) {
  return reason.find("is below confirm_score") == std::string::npos &&
         reason.rfind("graspable in ", 0) != 0 && reason.rfind("older than valid_until", 0) != 0;
}

}  // namespace

ThresholdPreview::ThresholdPreview(const mbncc_vision::DetectedObjectArray& all,
                                   const Thresholds& now)
    : all_(all), now_(now) {}

bool ThresholdPreview::reported(const mbncc_vision::DetectedObject& object,
                                const Thresholds& thresholds) {
  return object.score >= thresholds.min_score_of(object.name);
}

bool ThresholdPreview::graspable(const mbncc_vision::DetectedObject& object,
                                 const Thresholds& thresholds) {
  return reported(object, thresholds) && object.score >= thresholds.confirm_score &&
         std::none_of(object.reasons.begin(), object.reasons.end(), stays);
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

ThresholdPreview::Counts ThresholdPreview::count(const Thresholds& thresholds,
                                                 const std::string& name) const {
  Counts counts;
  for (const auto& object : all_.objects) {
    if (!name.empty() && object.name != name) continue;
    counts.reported += reported(object, thresholds) ? 1 : 0;
    counts.graspable += graspable(object, thresholds) ? 1 : 0;
  }
  return counts;
}

std::string ThresholdPreview::summary(const Thresholds& wanted, const std::string& object) const {
  const Counts then = count(wanted, object), now = count(now_, object);
  return (object.empty() ? "In this image" : "'" + object + "' in this image") + ": reported " +
         std::to_string(then.reported) + " (now " + std::to_string(now.reported) + "), graspable " +
         std::to_string(then.graspable) + " (now " + std::to_string(now.graspable) + ").";
}

}  // namespace mbncc::console
