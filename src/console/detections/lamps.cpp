// SPDX-License-Identifier: BSD-3-Clause
#include "console/detections/lamps.hpp"

#include "mbncc/health_tasks.hpp"

namespace mbncc::console {
namespace {

using mbncc_vision::DetectedObjectArray;

/// Source of a report: "left/camera: pictures" is the task "pictures" of a node in the namespace
/// "/left".
struct Reporter {
  std::string space, task;
};

Reporter reporter_of(const std::string& status_name) {
  const auto colon = status_name.rfind(": ");
  if (colon == std::string::npos) return {};
  const auto slash = status_name.substr(0, colon).rfind('/');
  const std::string space = slash == std::string::npos ? "" : status_name.substr(0, slash);
  return {"/" + space, status_name.substr(colon + 2)};
}

}  // namespace

void Lamps::take_detections(const DetectedObjectArray& detections, double now) {
  detections_at_ = now;
  status_ = detections.status;
  status_message_ = detections.message;
}

void Lamps::take_library(std::size_t objects, std::size_t enabled) {
  objects_ = objects;
  enabled_ = enabled;
}

void Lamps::take_diagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics, double now) {
  for (const auto& status : diagnostics.status) {
    const Reporter reporter = reporter_of(status.name);
    if (reporter.space != cell_) continue;
    health_[reporter.task] = {static_cast<std::uint8_t>(status.level), status.message, now};
    for (const auto& value : status.values)
      if (value.key == kQuarantinedKey) quarantined_ = value.value;
  }
}

std::string Lamps::complaint(const std::string& task, double now) const {
  const auto found = health_.find(task);
  if (found == health_.end() || now - found->second.at > 2 * kSilence) return "";
  return found->second.level == 0 ? "" : found->second.message;
}

Lamp Lamps::camera(double now) const {
  if (now - image_at_ <= kSilence)
    return {"Camera", origin_warning_.empty() ? Level::kGood : Level::kDoubtful, origin_warning_};
  const std::string said = complaint(kImagesTask, now);
  return {"Camera", Level::kBad,
          said.empty() ? "no image arrives; check cable, driver and topic" : said};
}

Lamp Lamps::calibration(double now) const {
  if (now - detections_at_ > kSilence || status_ == DetectedObjectArray::LIBRARY_EMPTY ||
      status_ == DetectedObjectArray::STALE || status_ == DetectedObjectArray::SEARCH_FAILED)
    return {"Calibration", Level::kUnknown, "unknown while nothing is searched"};
  if (status_ == DetectedObjectArray::UNCALIBRATED)
    return {"Calibration", Level::kDoubtful,
            status_message_.empty() ? "positions in pixels only" : status_message_};
  if (status_ == DetectedObjectArray::TF_UNAVAILABLE)
    return {"Calibration", Level::kBad, status_message_};
  return {"Calibration", Level::kGood, ""};
}

Lamp Lamps::library() const {
  if (!objects_) return {"Library", Level::kUnknown, "no report from the learning nodelet"};
  if (!quarantined_.empty() && quarantined_ != "0")
    return {"Library", Level::kDoubtful, quarantined_ + " unreadable file(s) in .quarantine"};
  if (*objects_ == 0) return {"Library", Level::kDoubtful, "empty: teach an object"};
  if (*enabled_ == 0) return {"Library", Level::kDoubtful, "every object is disabled"};
  return {"Library", Level::kGood, ""};
}

Lamp Lamps::matcher(double now) const {
  if (now - detections_at_ > kSilence) {
    const std::string said = complaint(kMatchingTask, now);
    return {"Matcher", Level::kBad, said.empty() ? "no report from the matching nodelet" : said};
  }
  switch (status_) {
    case DetectedObjectArray::STALE:
      return {"Matcher", Level::kBad,
              status_message_.empty() ? "no new image to search" : status_message_};
    case DetectedObjectArray::SEARCH_FAILED:
      return {"Matcher", Level::kBad, status_message_};
    case DetectedObjectArray::BUDGET_EXCEEDED:
      return {"Matcher", Level::kDoubtful, status_message_};
    case DetectedObjectArray::LIBRARY_EMPTY:
      return {"Matcher", Level::kDoubtful, "nothing to search for"};
    default:
      return {"Matcher", Level::kGood, ""};
  }
}

std::array<Lamp, 4> Lamps::look(double now) const {
  return {camera(now), calibration(now), library(), matcher(now)};
}

}  // namespace mbncc::console
