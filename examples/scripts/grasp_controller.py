#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Publishes where the gripper has to be to grasp the object, as long as it may be grasped."""
import rospy
from geometry_msgs.msg import PoseStamped

from mbncc_vision.msg import DetectedObject, DetectedObjectArray


def may_be_grasped(array, found):
    return (array.status in (DetectedObjectArray.OK, DetectedObjectArray.BUDGET_EXCEEDED)
            and found.state == DetectedObject.CONFIRMED and found.pose_valid
            and rospy.Time.now() <= found.valid_until)


class GraspController:
    def __init__(self):
        self.name = rospy.get_param("~object", "")  # "": any object
        self.target = rospy.Publisher("~target", PoseStamped, queue_size=1)
        rospy.Subscriber("detected_objects", DetectedObjectArray, self.on_detections, queue_size=1)

    def on_detections(self, array):
        wanted = [found for found in array.objects if self.name in ("", found.name)]
        for found in wanted:
            if may_be_grasped(array, found):
                self.move_to(array, found)
                return
        for reason in [array.message] + [reason for found in wanted for reason in found.reasons]:
            if reason:
                rospy.loginfo_throttle(5, reason)

    def move_to(self, array, found):
        """In place of a robot's motion, the pose is published."""
        self.target.publish(PoseStamped(array.header, found.grasp if found.has_grasp else found.pose.pose))


if __name__ == "__main__":
    rospy.init_node("grasp_controller")
    controller = GraspController()
    rospy.spin()
