// SPDX-License-Identifier: BSD-3-Clause
// Status lamps of the cell: camera, calibration, library, matcher; each with a reason unless it is
// blue.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <mbncc_vision/DetectedObjectArray.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "console/words.hpp"

namespace mbncc::console {

struct Lamp {
  const char* name = "";
  Level level = Level::kUnknown;
  std::string reason;  ///< "": no fault
};

/// All times are seconds of one steady clock.
class Lamps {
 public:
  /// A component that sends no report for this time counts as stopped. [s]
  static constexpr double kSilence = 2.0;

  /// `cell`: namespace of the cell's nodelets, "/" or "/left"; reports of other cells are ignored.
  explicit Lamps(std::string cell = "/") : cell_(std::move(cell)) {}

  void take_image(double now) { image_at_ = now; }
  /// `warning`: why the images are not live; "" if they are.
  void take_origin(const std::string& warning) { origin_warning_ = warning; }
  void take_detections(const mbncc_vision::DetectedObjectArray& detections, double now);
  void take_library(std::size_t objects, std::size_t enabled);
  /// Call this when the nodelet that manages the library has stopped.
  void forget_library() { objects_.reset(); }
  void take_diagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics, double now);

  std::array<Lamp, 4> look(double now) const;

 private:
  struct Health {
    std::uint8_t level = 0;
    std::string message;
    double at = -1e9;
  };

  Lamp camera(double now) const;
  Lamp calibration(double now) const;
  Lamp library() const;
  Lamp matcher(double now) const;
  /// The fault that the component reports; "" if there is none, or no report.
  std::string complaint(const std::string& task, double now) const;

  std::string cell_;
  double image_at_ = -1e9, detections_at_ = -1e9;
  std::uint8_t status_ = 0;
  std::string status_message_;
  std::optional<std::size_t> objects_, enabled_;
  std::string quarantined_, origin_warning_;
  std::map<std::string, Health> health_;  // reports of this cell, by task
};

}  // namespace mbncc::console
