// SPDX-License-Identifier: BSD-3-Clause
// Simulates the camera of a cell: publishes image_raw, camera_info, and the truth for the demo and
// the tests.
#include <image_transport/image_transport.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "mbncc/cell/platform.hpp"
#include "mbncc/health_tasks.hpp"
#include "mbncc/sim/cell_config.hpp"
#include "nodelets/camera/camera_health.hpp"
#include "nodelets/camera/simulated_optics.hpp"
#include "nodelets/common/guarded_nodelet.hpp"
#include "nodelets/common/health_report.hpp"
#include "nodelets/common/parameters.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"

namespace mbncc::nodelets {

class SimulatedCameraNodelet : public GuardedNodelet {
 public:
  ~SimulatedCameraNodelet() override { finish(); }

 private:
  using Counts = CameraHealth::Counts;

  void stop() override {
    report_.reset();
    timer_.stop();
  }

  void start() override {
    read_parameters(private_node(), field_rows(config_));
    scene_ = std::make_unique<sim::Scene>(sim::scene_config(config_));
    script_ = std::make_unique<sim::CellScript>(sim::script_config(config_));
    optics_ = std::make_unique<SimulatedOptics>(config_);
    image_transport::ImageTransport transport(node());
    camera_ = transport.advertiseCamera("image_raw", 1);
    ros::NodeHandle handle = private_node();
    truth_ = handle.advertise<mbncc_vision::DetectedObjectArray>("truth", 10, true);
    take_away_ = handle.advertiseService("take_away", &SimulatedCameraNodelet::on_take_away, this);
    put_next_ = handle.advertiseService("put_next", &SimulatedCameraNodelet::on_put_next, this);
    health_.set_state(diagnostic_msgs::DiagnosticStatus::OK, "open");
    report_ =
        std::make_unique<HealthReport>(node(), private_node(), getName(), "simulated cell",
                                       kImagesTask, [this](auto& status) { diagnose(status); });
    timer_ = handle.createWallTimer(ros::WallDuration(1 / config_.frame_rate),
                                    &SimulatedCameraNodelet::on_timer, this);
  }

  void on_timer(const ros::WallTimerEvent&) {
    script_->step();
    const sim::CellFrame frame = script_->frame();
    std_msgs::Header header;
    header.stamp = ros::Time::now();
    header.frame_id = config_.frame_id;
    // A simulated clock that does not advance gives no new stamp.
    if (header.stamp == last_stamp_) return health_.count(&Counts::unstamped);
    last_stamp_ = header.stamp;
    publish_image(frame, header);
    truth_.publish(truth_of(frame, header));
  }

  void publish_image(const sim::CellFrame& frame, const std_msgs::Header& header) {
    ++frames_;
    if (camera_.getNumSubscribers() == 0) return;
    const cv::Mat image = optics_->expose(scene_->render(frame.placed, frames_, frame.arm));
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>(optics_->camera_info());
    info->header = header;
    camera_.publish(boost::make_shared<sensor_msgs::Image>(encode_image(image, header)), info);
    health_.count(&Counts::published);
  }

  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    health_.describe(status);
    status.add("listeners", camera_.getNumSubscribers());
    status.add("calibrated", config_.focal_length > 0 ? "yes" : "no");
  }

  mbncc_vision::DetectedObjectArray truth_of(const sim::CellFrame& frame,
                                             const std_msgs::Header& header) const {
    mbncc_vision::DetectedObjectArray truth;
    truth.header = header;
    truth.message = sim::to_string(frame.phase);
    truth.searched = {config_.object_name};
    truth.image_width = optics_->camera_info().width;
    truth.image_height = optics_->camera_info().height;
    if (!frame.truth) return truth;
    Match match;
    match.name = config_.object_name;
    match.pose = *frame.truth;
    match.score = match.similarity = 1;
    auto object = to_msg(match, nullptr);
    const bool at_rest = frame.phase == sim::CellPhase::kRest;
    object.state =
        at_rest ? mbncc_vision::DetectedObject::CONFIRMED : mbncc_vision::DetectedObject::NEW;
    add_metric_pose(*frame.truth, object);
    truth.objects.push_back(object);
    return truth;
  }

  void add_metric_pose(const Pose2D& pose, mbncc_vision::DetectedObject& object) const {
    if (config_.focal_length == 0) return;
    const Platform platform(rays_of(optics_->pinhole()), plane_at(config_.platform_distance));
    auto lifted = platform.lift(pose, cv::Matx33d::zeros(), config_.object_height);
    if (!lifted) return;
    lifted->position = optics_->rotation().t() * lifted->position;
    lifted->rotation = optics_->rotation().t() * lifted->rotation;
    object.pose_valid = true;
    object.pose.pose = to_msg(*lifted).pose;
  }

  bool on_take_away(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const bool at_rest = script_->at_rest();
    response.success = script_->take_away();
    response.message = response.success ? "The arm takes the object away."
                       : at_rest        ? "No object lies on the platform; call put_next."
                                        : "The arm is moving; call again when it has left.";
    return true;
  }

  bool on_put_next(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    response.success = script_->put_next();
    response.message = response.success ? "The arm puts the object down at the next place."
                                        : "The arm is moving; call again when it has left.";
    return true;
  }

  SimulatedCameraConfig config_;
  std::unique_ptr<const SimulatedOptics> optics_;
  std::unique_ptr<const sim::Scene> scene_;
  std::unique_ptr<sim::CellScript> script_;
  std::uint64_t frames_ = 0;
  ros::Time last_stamp_;
  image_transport::CameraPublisher camera_;
  ros::Publisher truth_;
  ros::ServiceServer take_away_, put_next_;
  CameraHealth health_;
  std::unique_ptr<HealthReport> report_;
  ros::WallTimer timer_;
};

}  // namespace mbncc::nodelets

PLUGINLIB_EXPORT_CLASS(mbncc::nodelets::SimulatedCameraNodelet, nodelet::Nodelet)
