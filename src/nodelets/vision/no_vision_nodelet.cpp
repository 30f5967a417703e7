// SPDX-License-Identifier: BSD-3-Clause
// Replaces the vision nodelet if vision_msgs is not installed: reports this and idles. A nodelet
// that cannot be loaded would be started again every second.
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "mbncc/health_tasks.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"

namespace mbncc::nodelets {
namespace {

constexpr char kFault[] =
    "this package was built without vision_msgs; install vision_msgs and build it again, or leave "
    "out vision_msgs:=true";

}  // namespace

class VisionNodelet : public GuardedNodelet {
 public:
  ~VisionNodelet() override { finish(); }

 private:
  void start() override {
    NODELET_ERROR("%s", kFault);
    report_ = std::make_unique<HealthReport>(
        node(), private_node(), getName(), "none", kVisionTask,
        [](auto& status) { status.summary(diagnostic_msgs::DiagnosticStatus::ERROR, kFault); });
  }

  void stop() override { report_.reset(); }

  std::unique_ptr<HealthReport> report_;
};

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::VisionNodelet, nodelet::Nodelet)
