#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Processes that stop, die and come back: camera, subscriber, client of a lesson.

usage: process_faults_test.py

Camera, matching and learning run as separate processes with a separate master. Prints how long it took to detect
each fault and to recover from it; these times belong in docs/reliability.md.
"""
import os
import signal
import subprocess
import sys
import tempfile
import time
import xmlrpc.client

from own_master import DEADLINE, free_port, nodelet_program, published, stop, wait_for

TEACH = os.path.join(os.path.dirname(__file__), "../../../scripts/teach")
RATE = 50  # [Hz] of the camera
MOST_GROWTH = 5  # [MB]
LESSON_TIME = 3  # [s] of the lesson whose client dies
CALIBRATION = """image_width: 320
image_height: 240
camera_name: camera
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
camera_matrix: {rows: 3, cols: 3, data: [400, 0, 160, 0, 400, 120, 0, 0, 1]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [400, 0, 160, 0, 0, 400, 120, 0, 0, 0, 1, 0]}
"""


class Cell:
    """The processes, and the messages that a client receives."""

    def __init__(self, home, env):
        self._env = env
        self._started = []
        library = "_library_path:=" + os.path.join(home, "library")
        self.camera = self.start_nodelet(
            "CameraNodelet", "_source:=" + os.path.join(home, "images"), "_loop:=true", "_frame_rate:=%d" % RATE,
            "_camera_info_url:=file://" + os.path.join(home, "camera.yaml"))
        self.matching = self.start_nodelet("MatchingNodelet", library, "_platform_distance:=0.5", "_max_age:=5")
        self.learning = self.start_nodelet("LearningNodelet", library)

    def start_nodelet(self, name, *parameters):
        return self.start(nodelet_program(), "standalone", "mbncc_vision/" + name,
                          "__name:=" + name.lower(), *parameters)

    def start(self, *command, **options):
        process = subprocess.Popen(command, env=self._env, **options)
        self._started.append(process)
        return process

    def listen(self):
        import rospy
        from mbncc_vision.msg import DetectedObjectArray, LearnObjectActionFeedback, LearnObjectActionResult
        from tf2_msgs.msg import TFMessage
        self.array, self.arrays, self.heard = None, 0, 0.0  # heard: monotonic time of the last one that is not STALE
        self.silent = self.returned = self.transform = 0.0  # monotonic times of what followed
        self.feedback = self.deadline = self.result = self.ended = None
        self._stale = DetectedObjectArray.STALE
        self._subscribers = [
            rospy.Subscriber("detected_objects", DetectedObjectArray, self._take_array, queue_size=100),
            rospy.Subscriber("/tf", TFMessage, self._take_transform, queue_size=100),
            rospy.Subscriber("learn_object/feedback", LearnObjectActionFeedback, self._take_feedback),
            rospy.Subscriber("learn_object/result", LearnObjectActionResult, self._take_result)]

    def _take_array(self, array):
        now = time.monotonic()
        was_stale = self.array is not None and self.is_stale()
        self.array = array
        self.arrays += 1
        if self.is_stale():
            self.silent = self.silent if was_stale else now
        else:
            self.heard = now
            self.returned = now if was_stale else self.returned

    def _take_transform(self, _):
        self.transform = time.monotonic()

    def _take_feedback(self, feedback):
        self.deadline = time.monotonic() + feedback.feedback.remaining.to_sec()
        self.feedback = feedback

    def _take_result(self, result):
        self.result, self.ended = result, time.monotonic()

    def is_stale(self):
        return self.array is not None and self.array.status == self._stale

    def sees_the_part(self):
        return (self.array is not None and not self.is_stale() and
                any(found.child_frame_id for found in self.array.objects))

    def wait(self, predicate, what):
        wait_for(predicate, self.matching, what)

    def end(self):
        for process in reversed(self._started):
            if process.poll() is None:
                process.send_signal(signal.SIGCONT)
                stop(process)


def check(holds, what):
    if not holds:
        sys.exit("not so: " + what)


def resident(process):
    """Memory [MB]; None if /proc is not mounted."""
    try:
        with open("/proc/%d/statm" % process.pid) as pages:
            return int(pages.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 1e6
    except OSError:
        return None


def draw_images(home):
    """The part on its background, and the background alone."""
    import cv2
    import numpy
    random = numpy.random.RandomState(1)
    after = cv2.GaussianBlur(random.randint(0, 255, (240, 320, 3)).astype(numpy.uint8), (0, 0), 3)
    part = cv2.GaussianBlur(random.randint(0, 255, (70, 90, 3)).astype(numpy.uint8), (0, 0), 2)
    before = after.copy()
    before[80:150, 100:190] = cv2.convertScaleAbs(part, alpha=3, beta=-250)
    os.mkdir(os.path.join(home, "images"))
    for number in range(20):
        noise = random.normal(0, 2, before.shape)
        cv2.imwrite(os.path.join(home, "images", "%02d.png" % number), numpy.clip(before + noise, 0, 255))
    with open(os.path.join(home, "camera.yaml"), "w") as calibration:
        calibration.write(CALIBRATION)
    return before, after


def teach(cell, images, name):
    """A lesson with given images; returns its result."""
    import actionlib
    import rospy
    from mbncc_vision.msg import LearnObjectAction, LearnObjectGoal
    from sensor_msgs.msg import Image
    client = actionlib.SimpleActionClient("learn_object", LearnObjectAction)
    check(client.wait_for_server(rospy.Duration(DEADLINE)), "the lesson's server is there")
    before, after = (Image(height=240, width=320, encoding="bgr8", step=960, data=image.tobytes())
                     for image in images)
    client.send_goal(LearnObjectGoal(name=name, before=before, after=after, overwrite=True, allow_bad=True))
    # The state may arrive before the result.
    cell.wait(lambda: client.get_result() is not None, "result of the lesson of " + name)
    return client.get_result()


def stopped_camera(cell):
    """The camera stops and continues: STALE without objects and tf in between."""
    cell.wait(cell.sees_the_part, "the part confirmed")
    cell.camera.send_signal(signal.SIGSTOP)
    cell.wait(cell.is_stale, "STALE while the camera is stopped")
    check(not cell.array.objects, "a STALE array holds no object")
    print("camera stopped: STALE %.2f s after the last detections" % (cell.silent - cell.heard))
    before = cell.arrays
    cell.wait(lambda: cell.arrays >= before + 2, "STALE again")
    check(cell.transform < cell.silent, "no tf while the camera is stopped")
    resumed = time.monotonic()
    cell.camera.send_signal(signal.SIGCONT)
    cell.wait(lambda: cell.returned > resumed, "detections after the camera goes on")
    print("camera goes on: detections after %.2f s" % (cell.returned - resumed))
    cell.wait(cell.sees_the_part, "the part confirmed again")


def stopped_subscriber(cell, home):
    """A stopped subscriber does not delay others or use up memory."""
    heard = os.path.join(home, "overlay.txt")
    with open(heard, "w") as output:
        slow = cell.start("rostopic", "echo", "--noarr", "/matchingnodelet/overlay", stdout=output)
    cell.wait(lambda: os.path.getsize(heard) > 0, "the overlay heard")
    slow.send_signal(signal.SIGSTOP)
    sizes = []
    for _ in range(10):
        before = cell.arrays
        cell.wait(lambda: cell.arrays >= before + RATE // 2, "detections beside a stopped subscriber")
        check(not cell.is_stale(), "detections flow beside a stopped subscriber")
        sizes.append(resident(cell.matching))
    if sizes[0] is not None:
        growth = sizes[-1] - sizes[2]
        print("subscriber stopped for %d images of 0.23 MB: memory %+.1f MB" % (8 * RATE // 2, growth))
        check(growth < MOST_GROWTH, "memory is flat beside a stopped subscriber")
    size = os.path.getsize(heard)
    slow.send_signal(signal.SIGCONT)
    cell.wait(lambda: os.path.getsize(heard) > size, "the overlay heard again")
    stop(slow)


def killed_client(cell, images):
    """The lesson of a dead client ends at its time limit, and the next one is accepted."""
    client = cell.start(sys.executable, TEACH, "lonely", "--yes", "--timeout", str(LESSON_TIME),
                        stdout=subprocess.DEVNULL)
    cell.feedback = cell.result = None
    cell.wait(lambda: cell.feedback is not None, "feedback of the lesson")
    client.kill()
    client.wait()
    cell.wait(lambda: cell.result is not None, "the end of a lesson without a client")
    check(cell.result.result.error_code != 0, "a lesson without a client stores nothing")
    print("client killed: its lesson ended %.2f s after its time limit" % (cell.ended - cell.deadline))
    started = time.monotonic()
    check(teach(cell, images, "part").error_code == 0, "the next lesson is taken")
    print("next lesson: stored after %.2f s" % (time.monotonic() - started))


def run(home, env):
    images = draw_images(home)
    cell = Cell(home, env)
    try:
        import rospy
        rospy.init_node("peer", disable_signals=True)
        cell.listen()
        lesson = teach(cell, images, "part")
        check(lesson.error_code == 0, "the lesson is stored: " + lesson.message)
        stopped_camera(cell)
        stopped_subscriber(cell, home)
        killed_client(cell, images)
    finally:
        cell.end()


def main():
    with tempfile.TemporaryDirectory() as home:
        env = dict(os.environ, HOME=home, ROS_HOME=os.path.join(home, "log"), ROS_HOSTNAME="localhost",
                   ROS_LOG_DIR=os.path.join(home, "log"), ROS_MASTER_URI="http://localhost:%d" % free_port())
        os.environ.update(env)
        server = xmlrpc.client.ServerProxy(env["ROS_MASTER_URI"])
        core = subprocess.Popen(["roscore", "-p", env["ROS_MASTER_URI"].rsplit(":", 1)[1]], env=env,
                                stdout=subprocess.DEVNULL)
        try:
            wait_for(lambda: "/rosout_agg" in published(server), core, "roscore")
            run(home, env)
        finally:
            stop(core)


if __name__ == "__main__":
    main()
