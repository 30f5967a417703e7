#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Teaches the object of the simulated cell and compares the examples' output with the truth at each place."""
import atexit
import math
import re
import subprocess
import sys
import threading
import time

import actionlib
import rospy
from geometry_msgs.msg import PoseStamped
from moveit_msgs.msg import CollisionObject
from std_srvs.srv import Trigger

from mbncc_vision.msg import DetectedObjectArray, LearnObjectAction, LearnObjectFeedback, LearnObjectGoal

PLACES = 3
TOLERANCE = 1e-4  # [m]
DEADLINE = 60  # [s] generous; not reached unless a test fails
HEIGHT = 0.02  # [m]
GRASPING = ("controller_in_cpp/target", "controller_in_python/target")
POSING = ("vision_consumer/target", "collision_object")


def planar(pose):
    return (pose.position.x, pose.position.y, 2 * math.atan2(pose.orientation.z, pose.orientation.w))


def compose(outer, inner):
    c, s = math.cos(outer[2]), math.sin(outer[2])
    return (outer[0] + c * inner[0] - s * inner[1], outer[1] + s * inner[0] + c * inner[1], outer[2] + inner[2])


def relative(base, pose):
    """`pose` relative to `base`."""
    c, s = math.cos(base[2]), math.sin(base[2])
    x, y = pose[0] - base[0], pose[1] - base[1]
    return (c * x + s * y, -s * x + c * y, pose[2] - base[2])


class Session:
    """Stores the newest message of each topic."""

    def __init__(self):
        self.changed = threading.Condition()
        self.newest = {}
        for topic, kind in [("camera/truth", DetectedObjectArray), ("detected_objects", DetectedObjectArray),
                            ("collision_object", CollisionObject),
                            *((topic, PoseStamped) for topic in GRASPING + POSING[:1])]:
            rospy.Subscriber(topic, kind, self.take, topic)

    def take(self, message, topic):
        with self.changed:
            self.newest[topic] = message
            self.changed.notify_all()

    def wait(self, predicate, what):
        deadline = time.monotonic() + DEADLINE
        with self.changed:
            while not predicate(self.newest):
                if not self.changed.wait(deadline - time.monotonic()):
                    sys.exit("waited in vain for " + what)
            return dict(self.newest)

    def truth_at_rest(self, since=rospy.Time()):
        def rests(newest):
            truth = newest.get("camera/truth")
            return truth and truth.header.stamp > since and truth.message == "rest" and truth.objects
        return self.wait(rests, "the object at rest")["camera/truth"]

    def order(self, name):
        """Calls a service of the arm until the arm accepts; returns the stamp of a later image."""
        rospy.wait_for_service("camera/" + name, DEADLINE)
        call = rospy.ServiceProxy("camera/" + name, Trigger)
        self.wait(lambda newest: call().success, name)
        return self.wait(lambda newest: newest["camera/truth"].message != "rest", "the arm")["camera/truth"].header.stamp

    def teach(self):
        client = actionlib.SimpleActionClient("learn_object", LearnObjectAction)
        assert client.wait_for_server(rospy.Duration(DEADLINE)), "no action learn_object"
        shown = planar(self.truth_at_rest().objects[0].pose.pose)
        stages = []
        client.send_goal(LearnObjectGoal(name="part", object_height=HEIGHT),
                         feedback_cb=lambda feedback: self.take(feedback, "stage") or stages.append(feedback.stage))
        self.wait(lambda newest: LearnObjectFeedback.WAIT_REMOVAL in stages, "the lesson")
        marked = rospy.ServiceProxy("mark_grasp", Trigger)()
        assert marked.success, marked.message
        self.order("take_away")
        assert client.wait_for_result(rospy.Duration(DEADLINE)), "the lesson does not end"
        result = client.get_result()
        assert result.error_code == 0, result.message
        return shown, result.object


def turn(pose):
    return abs(math.degrees(math.remainder(pose, 2 * math.pi)))


def main():
    rospy.init_node("examples_session")
    session = Session()
    shown, known = session.teach()
    # Object frame and gripper relative to the frame of the truth, which is not that of the lesson.
    gripper = relative(shown, (0.01, 0.02, 0))
    reference = relative(gripper_of(known), (0, 0, 0))  # the object frame relative to the gripper
    worst = {}
    printer = Printer()
    for _ in range(PLACES):
        truth = session.truth_at_rest(session.order("put_next"))
        stamp = truth.header.stamp
        at = session.wait(lambda newest, stamp=stamp: all(
            topic in newest and newest[topic].header.stamp > stamp for topic in GRASPING + POSING), "the examples")
        grasp = compose(planar(truth.objects[0].pose.pose), gripper)
        expected = {topic: (grasp, 0.25) for topic in GRASPING}
        expected.update({topic: (compose(grasp, reference), 0.3 - HEIGHT) for topic in POSING})
        for topic, (pose, depth) in expected.items():
            found = at[topic].pose
            error = math.hypot(planar(found)[0] - pose[0], planar(found)[1] - pose[1])
            worst[topic] = max(worst.get(topic, 0), error)
            assert abs(found.position.z - depth) < TOLERANCE, (topic, found)
            assert turn(planar(found)[2] - pose[2]) < 0.5, (topic, found, pose)
        error = printer.check(stamp, compose(grasp, reference), 0.3 - HEIGHT)
        worst["print_poses.py"] = max(worst.get("print_poses.py", 0), error)
        check_body(at["collision_object"])
    for topic, error in sorted(worst.items()):
        print("%s: %.3f mm at worst of %d places" % (topic, 1000 * error, PLACES))
    assert max(worst.values()) < TOLERANCE


class Printer:
    """The example that prints poses."""

    def __init__(self):
        self._program = subprocess.Popen(["rosrun", "mbncc_vision_examples", "print_poses.py"], stdout=subprocess.PIPE,
                                         universal_newlines=True)
        atexit.register(self.stop)  # also if a check fails

    def check(self, stamp, pose, depth):
        """Returns the position error [m] in the first line about an image after `stamp`."""
        for line in self._program.stdout:
            if "yaw" not in line:  # rospy's log
                continue
            taken, x, y, z, yaw = (float(number) for number in re.findall(r"-?\d+\.\d+", line))
            if taken > stamp.to_sec() + 1e-3:
                assert abs(z - depth) < TOLERANCE and turn(math.radians(yaw) - pose[2]) < 0.5, (line, pose)
                return math.hypot(x - pose[0], y - pose[1])
        sys.exit("print_poses.py has ended")

    def stop(self):
        self._program.terminate()
        self._program.wait(DEADLINE)


def gripper_of(known):
    return planar(known.grasp)


def check_body(obstacle):
    assert obstacle.operation == CollisionObject.ADD
    mesh = obstacle.meshes[0]
    assert {round(vertex.z, 6) for vertex in mesh.vertices} == {0, HEIGHT}
    edges = {}  # in a closed mesh, each edge occurs once in each direction
    for triangle in mesh.triangles:
        a, b, c = triangle.vertex_indices
        for edge in ((a, b), (b, c), (c, a)):
            edges[edge] = edges.get(edge, 0) + 1
    assert all(count == 1 and edges.get((b, a)) == 1 for (a, b), count in edges.items())


if __name__ == "__main__":
    main()
