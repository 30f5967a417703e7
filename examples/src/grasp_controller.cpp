// SPDX-License-Identifier: BSD-3-Clause
// Publishes where the gripper has to be to grasp the object, as long as it may be grasped.
#include <geometry_msgs/PoseStamped.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/ros.h>

#include <string>

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

bool may_be_grasped(const DetectedObjectArray& array, const DetectedObject& object) {
  return (array.status == array.OK || array.status == array.BUDGET_EXCEEDED) &&
         object.state == object.CONFIRMED && object.pose_valid &&
         ros::Time::now() <= object.valid_until;
}

class GraspController {
 public:
  GraspController() {
    ros::NodeHandle node, settings("~");
    settings.param<std::string>("object", name_, "");
    target_ = settings.advertise<geometry_msgs::PoseStamped>("target", 1);
    detections_ = node.subscribe("detected_objects", 1, &GraspController::on_detections, this);
  }

 private:
  void on_detections(const DetectedObjectArray& array) {
    for (const auto& object : array.objects) {
      const bool wanted = name_.empty() || object.name == name_;
      if (wanted && may_be_grasped(array, object)) return move_to(array, object);
      if (wanted && !object.reasons.empty())
        ROS_INFO_THROTTLE(5, "%s: %s", object.name.c_str(), object.reasons.front().c_str());
    }
    if (!array.message.empty()) ROS_WARN_THROTTLE(5, "%s", array.message.c_str());
  }

  /// In place of a robot's motion, the pose is published.
  void move_to(const DetectedObjectArray& array, const DetectedObject& object) {
    geometry_msgs::PoseStamped target;
    target.header = array.header;
    target.pose = object.has_grasp ? object.grasp : object.pose.pose;
    target_.publish(target);
  }

  std::string name_;  // "": any object
  ros::Publisher target_;
  ros::Subscriber detections_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "grasp_controller");
  const GraspController controller;
  ros::spin();
}
