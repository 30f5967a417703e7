#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Waits for an object that may be grasped, and prints where. An example of a careful consumer.

It acts on detected_objects alone: the object must be CONFIRMED, have a pose in metres, and its
valid_until must not have passed at the moment of acting. An array that is stale or in pixels only,
an ambiguous, new or held object, and silence are all refused, with the reason. Exits 0 with the
pose on standard output, 1 when nothing could be grasped in time.
"""
import argparse
import sys
import threading
import time

import rosgraph
import rospy

from mbncc_vision.msg import DetectedObject, DetectedObjectArray, LearnedObjectArray

STATES = {DetectedObject.NEW: "not graspable, or not often enough yet",
          DetectedObject.AMBIGUOUS: "ambiguous",
          DetectedObject.HELD: "held: not seen in the last image"}


def array_fault(array):
    """Why nothing of the array may be grasped; None when something may."""
    if array.status == DetectedObjectArray.LIBRARY_EMPTY:
        return "nothing is searched for: " + array.message
    if array.status == DetectedObjectArray.STALE:
        return "stale: " + array.message
    if array.status == DetectedObjectArray.UNCALIBRATED:
        return "no poses in metres: " + array.message
    if array.status == DetectedObjectArray.TF_UNAVAILABLE:
        return "not in the wanted frame: " + array.message
    # This also covers a status that this program does not know yet.
    if array.status not in (DetectedObjectArray.OK, DetectedObjectArray.BUDGET_EXCEEDED):
        return "not reliable: " + array.message
    return None


def object_fault(found, now):
    """Why the object may not be grasped now; None when it may."""
    if found.state != DetectedObject.CONFIRMED:
        return STATES.get(found.state, "in an unknown state") + "".join(": " + reason for reason in found.reasons[:1])
    if not found.pose_valid:
        return "without a pose in metres"
    if now > found.valid_until:
        return "seen too long ago"
    return None


def absence(array, name):
    """Why no object of that name is listed. An object that could be one of several is listed under one name only."""
    if not name:
        return "no object in view"
    others = ["%s #%d" % (found.name, found.instance_id) for found in array.objects
              if found.state == DetectedObject.AMBIGUOUS]
    return "no %s in view" % name + ("; ambiguous, may be it: " + ", ".join(others) if others else "")


def choose(array, name, now):
    """The best object that may be grasped now, and why the others may not."""
    fault = array_fault(array)
    if fault:
        return None, [fault]
    reasons = []
    for found in array.objects:
        if name and found.name != name:
            continue
        fault = object_fault(found, now)
        if fault is None:
            return found, []
        reasons.append("%s #%d is %s" % (found.name, found.instance_id, fault))
    return None, reasons or [absence(array, name)]


def unknown(name, library):
    """A message for a name that is missing in the library, otherwise none; also none without a library message."""
    if not name or not library or name in library:
        return []
    return ["the library has no '%s', it has %s" % (name, ", ".join(sorted(library)))]


class GraspClient:
    """Receives the detections; only the newest array is used."""

    def __init__(self):
        self.condition = threading.Condition()
        self.array = None
        self.library = {}
        rospy.Subscriber("object_library", LearnedObjectArray, self.on_library, queue_size=1)
        rospy.Subscriber("detected_objects", DetectedObjectArray, self.on_array, queue_size=1)

    def on_library(self, library):
        self.library = {known.name: known for known in library.objects}

    def on_array(self, array):
        with self.condition:
            self.array = array
            self.condition.notify_all()

    def wait(self, name, timeout):
        """(object, its array's header) that may be grasped now, or (None, reasons)."""
        # The steady clock, because a simulated one may stop.
        deadline = time.monotonic() + timeout
        reasons = ["nothing comes on %s; is the cell running, and its matching enabled?"
                   % rospy.resolve_name("detected_objects")]
        with self.condition:
            while time.monotonic() < deadline and not rospy.is_shutdown():
                self.condition.wait(0.1)
                array, self.array = self.array, None
                if array is None:
                    continue
                found, reasons = choose(array, name, rospy.Time.now())
                if found:
                    return found, array.header
        return None, reasons + unknown(name, self.library)


def describe(found, header, grasp, now):
    p, q = found.pose.pose.position, found.pose.pose.orientation
    lines = ["%s #%d in %s, valid for %.2f s, until %.3f" %
             (found.name, found.instance_id, header.frame_id, (found.valid_until - now).to_sec(),
              found.valid_until.to_sec()),
             "position %.5f %.5f %.5f m" % (p.x, p.y, p.z),
             "orientation %.5f %.5f %.5f %.5f" % (q.x, q.y, q.z, q.w)]
    if grasp and found.child_frame_id:  # without tf there is no frame to name
        lines.append("grasp frame %s_grasp" % found.child_frame_id)
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--name", default="", help="object to wait for; default: any")
    parser.add_argument("--timeout", type=float, default=10, help="[s] to wait")
    arguments = parser.parse_args(rospy.myargv()[1:])
    if not rosgraph.is_master_online():
        sys.exit("no ROS master at %s; start cell.launch or set ROS_MASTER_URI" % rosgraph.get_master_uri())
    rospy.init_node("grasp_client", anonymous=True)
    client = GraspClient()
    found, rest = client.wait(arguments.name, arguments.timeout)
    if not found:
        sys.exit("nothing to grasp: " + "; ".join(rest))
    known = client.library.get(found.name)
    print(describe(found, rest, known and known.has_grasp, rospy.Time.now()))


if __name__ == "__main__":
    main()
