// SPDX-License-Identifier: BSD-3-Clause
// Publishes a nodelet's diagnostics once a second, by wall time because a simulated clock
// may stop.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>

namespace mbncc::nodelets {

class HealthReport {
 public:
  /// `name` is the name of the nodelet, `hardware` the hardware id, and `task` the name of the
  /// status that `describe` fills in.
  HealthReport(ros::NodeHandle node, ros::NodeHandle private_node, const std::string& name,
               const std::string& hardware, const std::string& task,
               const diagnostic_updater::TaskFunction& describe)
      : updater_(node, private_node, name) {
    updater_.setHardwareID(hardware);
    updater_.add(task, describe);
    timer_ = node.createWallTimer(ros::WallDuration(1),
                                  [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  }
  ~HealthReport() { timer_.stop(); }

 private:
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace mbncc::nodelets
