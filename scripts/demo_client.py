#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Teaches the object of the simulated cell and finds it again at places the arm puts it down.

Runs against demo.launch with auto_play:=false. Prints the lesson's feedback and each found pose
beside its true one, writes an overlay image, and exits 0 when the object was learned and found
at five poses or more within 1.5 px and 1.5 degrees, else 1.
"""
import argparse
import math
import sys
import threading
import time

import actionlib
import cv2
import numpy
import rospy
from actionlib_msgs.msg import GoalStatus
from sensor_msgs.msg import Image
from std_srvs.srv import Trigger

from mbncc_vision.msg import (DetectedObject, DetectedObjectArray, LearnObjectAction,
                              LearnObjectFeedback, LearnObjectGoal)

STAGES = ["WAIT_IMAGE", "WAIT_REMOVAL", "WAIT_STILL", "REGION", "SEGMENT", "QUALITY",
          "WAIT_CONFIRM", "STORE"]
MAX_OFFSET = 1.5  # [px]
MAX_TURN = 1.5  # [deg]
NEEDED = 5  # poses found


class DemoFailed(Exception):
    """Ends the demo with a message."""


def compose(outer, inner):
    """Pose (x, y, theta) of the inner frame in the outer one's parent."""
    c, s = math.cos(outer[2]), math.sin(outer[2])
    return (outer[0] + c * inner[0] - s * inner[1], outer[1] + s * inner[0] + c * inner[1],
            outer[2] + inner[2])


def inverse(pose):
    c, s = math.cos(pose[2]), math.sin(pose[2])
    return (-c * pose[0] - s * pose[1], s * pose[0] - c * pose[1], -pose[2])


def as_tuple(pose):
    return (pose.x, pose.y, pose.theta)


def offset(a, b):
    """Distance [px] and angle [deg] between two poses."""
    turn = math.remainder(a[2] - b[2], 2 * math.pi)
    return math.hypot(a[0] - b[0], a[1] - b[1]), abs(math.degrees(turn))


class Newest:
    """The newest message of a topic, and waiting for one that fits."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self._message = None
        self._subscriber = rospy.Subscriber(topic, kind, self._take, queue_size=5)

    def _take(self, message):
        with self._changed:
            self._message = message
            self._changed.notify_all()

    def wait(self, fits, timeout, what):
        deadline = time.monotonic() + timeout
        with self._changed:
            while self._message is None or not fits(self._message):
                left = deadline - time.monotonic()
                if left <= 0 or rospy.is_shutdown():
                    raise DemoFailed("waited %d s in vain for %s" % (timeout, what))
                self._changed.wait(min(left, 0.5))
            return self._message


class Demo:
    def __init__(self, arguments):
        self.name = arguments.name
        self.timeout = arguments.timeout
        self.truth = Newest("camera/truth", DetectedObjectArray)
        self.detections = Newest("detected_objects", DetectedObjectArray)
        self.overlay = Newest("matching/overlay", Image)

    def order(self, command):
        """Commands the arm to move; waits while it is moving."""
        service = "camera/" + command
        try:
            rospy.wait_for_service(service, self.timeout)
        except rospy.ROSException as error:
            raise DemoFailed("the simulated camera is not there: %s" % error)
        deadline = time.monotonic() + self.timeout
        while time.monotonic() < deadline:
            answer = rospy.ServiceProxy(service, Trigger)()
            if answer.success:
                print("  arm: " + answer.message)
                return
            time.sleep(0.2)
        raise DemoFailed("the arm does not %s: %s" % (command, answer.message))

    def wait_for_rest(self, present):
        return self.truth.wait(
            lambda truth: truth.message == "rest" and bool(truth.objects) == present, self.timeout,
            "the arm to come to rest")

    def learn(self):
        print("Teaching '%s': the arm takes it away." % self.name)
        start = self.wait_for_rest(True)
        client = actionlib.SimpleActionClient("learn_object", LearnObjectAction)
        if not client.wait_for_server(rospy.Duration(self.timeout)):
            raise DemoFailed("nobody serves learn_object; is the learning nodelet running?")
        goal = LearnObjectGoal(name=self.name, mode=LearnObjectGoal.CHANGE, overwrite=True)
        goal.timeout = rospy.Duration(self.timeout)
        removal = threading.Event()
        client.send_goal(goal, feedback_cb=lambda feedback: self.tell(feedback, removal))
        if not removal.wait(self.timeout):
            client.cancel_goal()
            raise DemoFailed("the lesson never asked to take the object away")
        self.order("take_away")
        if not client.wait_for_result(rospy.Duration(self.timeout)):
            raise DemoFailed("the lesson did not end")
        result = client.get_result()
        if client.get_state() != GoalStatus.SUCCEEDED:
            raise DemoFailed("%s %s" % (result.message, result.hint))
        print("  %s Area %d px." % (result.message, result.object.quality.area))
        for advice in result.object.quality.advice:
            print("  " + advice)
        # The reference point in the object's drawing, independent of the map's centroid.
        return compose(inverse(as_tuple(start.objects[0].image_pose)),
                       as_tuple(result.object.reference))

    @staticmethod
    def tell(feedback, removal):
        print("  %3d %% %-12s %s" % (100 * feedback.progress, STAGES[feedback.stage],
                                     feedback.message))
        if feedback.stage == LearnObjectFeedback.WAIT_REMOVAL:
            removal.set()

    def confirmed(self, detections, since):
        """The surest confirmed instance of our object in an image taken since then."""
        if detections.header.stamp <= since:
            return None
        fitting = [found for found in detections.objects
                   if found.name == self.name and found.state == DetectedObject.CONFIRMED]
        return fitting[0] if fitting else None

    def find(self, reference):
        """Puts the object down at the next place; true when it was found there."""
        self.order("put_next")
        truth = self.truth.wait(lambda truth: truth.message != "rest", self.timeout,
                                "the arm to start")
        truth = self.wait_for_rest(True)
        true = compose(as_tuple(truth.objects[0].image_pose), reference)
        try:
            detections = self.detections.wait(
                lambda found: self.confirmed(found, truth.header.stamp), self.timeout,
                "a confirmed detection")
        except DemoFailed as error:
            print("  true (%.2f, %.2f) px %.2f deg: %s" % (true[0], true[1],
                                                           math.degrees(true[2]), error))
            return False
        found = self.confirmed(detections, truth.header.stamp)
        pose = as_tuple(found.image_pose)
        distance, turn = offset(pose, true)
        good = distance <= MAX_OFFSET and turn <= MAX_TURN
        print("  found (%.2f, %.2f) px %.2f deg, true (%.2f, %.2f) px %.2f deg: "
              "off by %.2f px, %.2f deg, score %.2f%s" %
              (pose[0], pose[1], math.degrees(pose[2]), true[0], true[1],
               math.degrees(math.remainder(true[2], 2 * math.pi)), distance, turn, found.score,
               "" if good else "  TOO FAR"))
        return good

    def save_overlay(self, path):
        now = rospy.Time.now()
        message = self.overlay.wait(lambda image: image.header.stamp >= now, self.timeout,
                                    "an overlay image")
        image = numpy.frombuffer(message.data, numpy.uint8).reshape(message.height, -1, 3)
        if not cv2.imwrite(path, image):
            raise DemoFailed("cannot write %s" % path)
        print("Overlay image: " + path)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--overlay", default="demo_overlay.png", help="image to write")
    parser.add_argument("--poses", type=int, default=6, help="places to find the object at")
    parser.add_argument("--name", default="demo_object", help="name to teach it under")
    parser.add_argument("--timeout", type=float, default=60, help="[s] patience with each step")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("demo_client", anonymous=True)
    demo = Demo(arguments)
    try:
        reference = demo.learn()
        print("Finding it at %d places:" % arguments.poses)
        good = sum(demo.find(reference) for _ in range(arguments.poses))
        demo.save_overlay(arguments.overlay)
    except (DemoFailed, rospy.ServiceException) as error:
        print("Demo failed: %s" % error, file=sys.stderr)
        return 1
    print("Learned, and found at %d of %d poses." % (good, arguments.poses))
    return 0 if good >= NEEDED else 1


if __name__ == "__main__":
    sys.exit(main())
