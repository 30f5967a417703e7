#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps detections, graspable or not, as obstacles in MoveIt's planning scene: outline by height."""
import cv2
import numpy
import rospy
from geometry_msgs.msg import Point, Pose, Quaternion
from moveit_msgs.msg import CollisionObject
from shape_msgs.msg import Mesh, MeshTriangle

from mbncc_vision.msg import DetectedObject, DetectedObjectArray

GONE_AFTER = rospy.Duration(5)  # an arm may hide an object while it passes
UPRIGHT = Pose(orientation=Quaternion(w=1))


def prism(footprint):
    """The outline's convex hull, from the top face (z = 0) down to the platform."""
    base = footprint[0].z
    hull = cv2.convexHull(numpy.array([[p.x, p.y] for p in footprint], numpy.float32))[:, 0].tolist()
    count = len(hull)
    mesh = Mesh(vertices=[Point(x, y, z) for z in (0, base) for x, y in hull])
    for i in range(count):
        j = (i + 1) % count
        mesh.triangles += [MeshTriangle([i, j, count + i]), MeshTriangle([j, count + j, count + i])]
    for i in range(1, count - 1):
        mesh.triangles += [MeshTriangle([0, i + 1, i]), MeshTriangle([count, count + i, count + i + 1])]
    return mesh


class PlanningScene:
    def __init__(self):
        self.last_seen = {}  # stamp by obstacle
        self.scene = rospy.Publisher("collision_object", CollisionObject, queue_size=10)
        rospy.Subscriber("detected_objects", DetectedObjectArray, self.on_detections, queue_size=1)

    def on_detections(self, array):
        if array.status not in (DetectedObjectArray.OK, DetectedObjectArray.BUDGET_EXCEEDED):
            return
        for found in (one for one in array.objects
                      if one.state != DetectedObject.HELD and one.pose_valid and one.footprint.points):
            name = "%s_%d" % (found.name, found.instance_id)
            self.last_seen[name] = array.header.stamp
            self.scene.publish(CollisionObject(
                header=array.header, id=name, pose=found.pose.pose, operation=CollisionObject.ADD,
                meshes=[prism(found.footprint.points)], mesh_poses=[UPRIGHT]))
        for name in [name for name, seen in self.last_seen.items() if array.header.stamp - seen > GONE_AFTER]:
            del self.last_seen[name]
            self.scene.publish(CollisionObject(header=array.header, id=name, operation=CollisionObject.REMOVE))


if __name__ == "__main__":
    rospy.init_node("planning_scene")
    scene = PlanningScene()
    rospy.spin()
