#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Publishes the pose of the best object of a name, using only vision_msgs (cell.launch vision_msgs:=true)."""
import rospy
from geometry_msgs.msg import PoseStamped
from vision_msgs.msg import Detection3DArray, VisionInfo


class VisionConsumer:
    def __init__(self):
        self.name = rospy.get_param("~object", "")  # "": any object
        self.names = {}  # by number
        self.target = rospy.Publisher("~target", PoseStamped, queue_size=1)
        rospy.Subscriber("vision/vision_info", VisionInfo, self.on_info, queue_size=1)
        rospy.Subscriber("vision/detections_3d", Detection3DArray, self.on_detections, queue_size=1)

    def on_info(self, info):
        self.names = {number: name for name, number in rospy.get_param(info.database_location).items()}

    def on_detections(self, array):
        """The graspable objects of vision_msgs; an empty array means that there are none."""
        for detection in array.detections:
            best = max(detection.results, key=lambda result: result.score)
            if self.name in ("", self.names.get(best.id)):
                self.target.publish(PoseStamped(array.header, best.pose.pose))
                return


if __name__ == "__main__":
    rospy.init_node("vision_consumer")
    consumer = VisionConsumer()
    rospy.spin()
