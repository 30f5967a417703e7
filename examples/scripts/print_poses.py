#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints position and yaw of each object that may be grasped, and otherwise why there is none."""
import math

import rospy

from mbncc_vision.msg import DetectedObject, DetectedObjectArray


def may_be_grasped(array, found):
    return (array.status in (DetectedObjectArray.OK, DetectedObjectArray.BUDGET_EXCEEDED)
            and found.state == DetectedObject.CONFIRMED and found.pose_valid
            and rospy.Time.now() <= found.valid_until)


def yaw(q):
    """Direction of the object's x axis about z of the array's frame, [deg]; also if the object's z points down."""
    return math.degrees(math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y ** 2 + q.z ** 2)))


def print_poses(array):
    if array.message:
        rospy.loginfo_throttle(5, array.message)
    for found in array.objects:
        if may_be_grasped(array, found):
            p, q = found.pose.pose.position, found.pose.pose.orientation
            print("%.3f %s in %s: x %.5f y %.5f z %.5f m, yaw %.2f deg" %
                  (array.header.stamp.to_sec(), found.name, array.header.frame_id, p.x, p.y, p.z, yaw(q)), flush=True)
        elif found.reasons:
            rospy.loginfo_throttle(5, "%s: %s", found.name, found.reasons[0])


if __name__ == "__main__":
    rospy.init_node("print_poses")
    rospy.Subscriber("detected_objects", DetectedObjectArray, print_poses, queue_size=1)
    rospy.spin()
