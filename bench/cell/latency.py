#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Latency and CPU time of a running cell: 30 images per second of 640 x 480, five objects, one manager.

usage: latency.py PATH/TO/mbncc [--seconds S] [--rate HZ] [--play] [--recorded N] [--queue N] [--cells N]
(in a shell that has sourced the build; starts its own master)

Teaches five simulated objects, plays the simulated cell, and prints the times that detected_objects reports, the lag
of tf behind the images' stamps, and the CPU time of the nodelets: while searching, with ~enable false, and with only
the learning nodelet watching the still scene. The simulated camera runs in a separate process and is not counted. With
--recorded, its images are first recorded at 15 Hz and then played by the camera nodelet, which reaches rates that the
simulation does not. --queue is the matching nodelet's queue_size. With --cells, this number of cells run at once
instead, each in a namespace with its own manager, with one library.
"""
import argparse
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time

import numpy as np

SIMULATED = """
  <node pkg="nodelet" type="nodelet" name="camera" clear_params="true" args="standalone mbncc_vision/SimulatedCameraNodelet">
    <param name="frame_rate" value="{rate}"/>
    <param name="auto_play" value="{play}"/>
    <param name="object_seed" value="1"/>
    <param name="seed" value="1"/>
  </node>
"""

RECORDED = """
  <node pkg="nodelet" type="nodelet" name="camera" clear_params="true" args="standalone mbncc_vision/CameraNodelet">
    <param name="source" value="{images}"/>
    <param name="frame_rate" value="{rate}"/>
    <param name="loop" value="true"/>
    <param name="camera_info_url" value="file://{images}/camera.yaml"/>
  </node>
"""

CELL = """
  <include file="$(find mbncc_vision)/launch/cell.launch">
    <arg name="camera" value="false"/>
    <arg name="library" value="{library}"/>
    <arg name="learning" value="{learning}"/>
    <arg name="platform_distance" value="0.6"/>
    <arg name="tf_prefix" value="{prefix}"/>
  </include>
  <param name="matching/queue_size" value="{queue}"/>
"""


def teach(tool, folder):
    library = os.path.join(folder, "library")
    for seed in range(1, 6):
        images = os.path.join(folder, "cell%d" % seed)
        subprocess.run([tool, "simulate", "--out", images, "--seed", str(seed), "--count", "1"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([tool, "learn", "--library", library, "--name", "part%d" % seed, "--allow-bad", "--before",
                        images + "/before.png", "--after", images + "/after.png"], check=True,
                       stdout=subprocess.DEVNULL)
    return library


def calibration_of(info):
    def matrix(name, values, rows):
        return "%s: {rows: %d, cols: %d, data: %s}" % (name, rows, len(values) // rows, list(values))
    return "\n".join(["image_width: %d" % info.width, "image_height: %d" % info.height, "camera_name: camera",
                      matrix("camera_matrix", info.K, 3), "distortion_model: plumb_bob",
                      matrix("distortion_coefficients", info.D or [0] * 5, 1), matrix("rectification_matrix", info.R, 3),
                      matrix("projection_matrix", info.P, 3), ""])


def record(folder, count):
    """Records images and camera.yaml of the running simulated camera."""
    import cv2
    import rospy
    from cv_bridge import CvBridge
    from sensor_msgs.msg import CameraInfo, Image
    os.makedirs(folder)
    rospy.init_node("latency", anonymous=True)
    info = rospy.wait_for_message("camera_info", CameraInfo, 60)
    with open(os.path.join(folder, "camera.yaml"), "w", encoding="utf-8") as file:
        file.write(calibration_of(info))
    bridge, written = CvBridge(), []

    def keep(message):
        if len(written) < count:
            written.append(os.path.join(folder, "%06d.bmp" % len(written)))
            cv2.imwrite(written[-1], bridge.imgmsg_to_cv2(message, "bgr8"))

    heard = rospy.Subscriber("image_raw", Image, keep, queue_size=10)
    while len(written) < count:
        time.sleep(0.1)
    heard.unregister()


def cpu_seconds(pid):
    with open("/proc/%d/stat" % pid, encoding="ascii") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def manager_pid(cell=""):
    listed = subprocess.run(["rosnode", "info", cell + "/mbncc_manager"], capture_output=True, text=True, check=True)
    return int(next(line.split()[1] for line in listed.stdout.splitlines() if line.startswith("Pid")))


def share_of_core(pid, seconds):
    begin = cpu_seconds(pid)
    time.sleep(seconds)
    return (cpu_seconds(pid) - begin) / seconds


def line(name, values):
    values = 1e3 * np.asarray(values)
    print("| %s | %d | %.1f | %.1f | %.1f |" % (name, len(values), *np.percentile(values, [50, 99]), values.max()))


def measure(seconds):
    import rospy
    from std_srvs.srv import SetBool
    from tf2_msgs.msg import TFMessage
    from mbncc_vision.msg import DetectedObjectArray
    from sensor_msgs.msg import CameraInfo
    rospy.init_node("latency", anonymous=True)
    arrays, lags, shown = [], [], []
    heard = rospy.Subscriber("detected_objects", DetectedObjectArray, arrays.append, queue_size=100)
    seen = rospy.Subscriber("camera_info", CameraInfo, lambda info: shown.append(info.header.stamp), queue_size=100)
    # Uses the newest stamp of each message: if another instance takes over a stable frame, an older
    # one is sent along.
    rospy.Subscriber("/tf", TFMessage, lambda message: lags.append(
        (rospy.Time.now() - max(t.header.stamp for t in message.transforms)).to_sec()), queue_size=100)
    rospy.wait_for_service("matching/enable", 60)
    deadline = time.monotonic() + 60
    while not lags and time.monotonic() < deadline:
        time.sleep(0.1)
    pid = manager_pid()
    del arrays[:], lags[:], shown[:]
    begin = rospy.Time.now()  # answers to earlier images may have been deleted
    searching = share_of_core(pid, seconds)
    print("| of | images | p50 ms | p99 ms | worst ms |\n|---|---:|---:|---:|---:|")
    line("search time", [array.search_time for array in arrays])
    line("latency, stamp to publishing", [array.latency for array in arrays])
    line("tf lag, stamp to arrival here", lags or [np.nan])
    print("\nimages searched per second: %.1f" % (len(arrays) / seconds))
    seen.unregister()
    time.sleep(1)  # waits for the answers to the last images
    heard.unregister()
    answered = {array.header.stamp for array in arrays}
    shown = [stamp for stamp in shown if stamp >= begin]
    lost = [(stamp - begin).to_sec() for stamp in shown if stamp not in answered]
    print("images without an answer: %d of %d%s" % (len(lost), len(shown), "".join(", at %.2f s" % s for s in lost)))
    typical = np.median([array.search_time for array in arrays])
    print("latency by the median search time: p50 %.1f, p99 %.1f" %
          tuple(np.percentile([array.latency for array in arrays], [50, 99]) / typical))
    enable = rospy.ServiceProxy("matching/enable", SetBool)
    enable(False)
    time.sleep(1)
    watching = share_of_core(pid, min(20, seconds))
    print("CPU of the manager, searching: %.0f %%; ~enable false, learning watches the scene: %.1f %%" %
          (100 * searching, 100 * watching))


def measure_idle(seconds):
    import rospy
    from std_srvs.srv import SetBool
    rospy.wait_for_service("matching/enable", 60)
    rospy.ServiceProxy("matching/enable", SetBool)(False)
    time.sleep(2)
    print("~enable false, no learning nodelet: %.2f %%" % (100 * share_of_core(manager_pid(), seconds)))


def measure_cells(cells, seconds):
    import rospy
    from mbncc_vision.msg import DetectedObjectArray
    rospy.init_node("latency", anonymous=True)
    arrays = {cell: [] for cell in cells}
    for cell in cells:
        rospy.wait_for_service(cell + "/matching/enable", 60)
        rospy.Subscriber(cell + "/detected_objects", DetectedObjectArray, arrays[cell].append, queue_size=100)
    time.sleep(10)  # waits for the first searches
    pids = {cell: manager_pid(cell) for cell in cells}
    for heard in arrays.values():
        del heard[:]
    begin = {cell: cpu_seconds(pids[cell]) for cell in cells}
    time.sleep(seconds)
    print("| cell | images per second | CPU of the manager | of which per image | latency p50 ms | p99 ms |\n"
          "|---|---:|---:|---:|---:|---:|")
    for cell in cells:
        used, heard = cpu_seconds(pids[cell]) - begin[cell], list(arrays[cell])
        print("| %s | %.1f | %.1f %% | %.2f ms | %.1f | %.1f |" %
              (cell, len(heard) / seconds, 100 * used / seconds, 1e3 * used / max(1, len(heard)),
               *(1e3 * np.percentile([array.latency for array in heard] or [np.nan], [50, 99]))))


def run(port, folder, content, measurement):
    launch = os.path.join(folder, "latency.launch")
    with open(launch, "w", encoding="utf-8") as file:
        file.write("<launch>" + content + "</launch>\n")
    cell = subprocess.Popen(["roslaunch", "-p", str(port), launch], stdout=subprocess.DEVNULL)
    try:
        time.sleep(5)
        measurement()
    finally:
        cell.send_signal(signal.SIGINT)
        cell.wait(30)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool", help="the built mbncc")
    parser.add_argument("--seconds", type=float, default=20, help="of each measurement (20)")
    parser.add_argument("--rate", type=float, default=30, help="images a second (30)")
    parser.add_argument("--play", action="store_true", help="the arm moves the object; without it, the scene is still")
    parser.add_argument("--cells", type=int, default=0, help="so many at once, only their cost; 0: one, in full (0)")
    parser.add_argument("--queue", type=int, default=1, help="images that may wait for the search (1)")
    parser.add_argument("--recorded", type=int, default=0, help="images to record first; 0: draw them on the way (0)")
    arguments = parser.parse_args()
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    os.environ["ROS_MASTER_URI"] = "http://localhost:%d" % port
    with tempfile.TemporaryDirectory() as folder:
        library = teach(arguments.tool, folder)
        master = subprocess.Popen(["roscore", "-p", str(port)], stdout=subprocess.DEVNULL)
        try:
            import rosgraph
            while not rosgraph.is_master_online():
                time.sleep(0.2)
            settings = {"library": library, "rate": arguments.rate, "play": str(arguments.play).lower(),
                        "queue": arguments.queue, "images": os.path.join(folder, "images")}
            if arguments.recorded:
                run(port, folder, SIMULATED.format(**dict(settings, rate=15)),
                    lambda: record(settings["images"], arguments.recorded))
            cell = (RECORDED if arguments.recorded else SIMULATED) + CELL
            if arguments.cells:
                names = ["/cell%d" % number for number in range(arguments.cells)]
                groups = "".join('<group ns="%s">%s</group>' %
                                 (name, cell.format(learning="true", prefix=name[1:] + "_", **settings)) for name in names)
                run(port, folder, groups,
                    lambda: measure_cells(names, arguments.seconds))
                return
            run(port, folder, cell.format(learning="true", prefix="", **settings), lambda: measure(arguments.seconds))
            run(port, folder, cell.format(learning="false", prefix="", **settings),
                lambda: measure_idle(min(20, arguments.seconds)))
        finally:
            master.send_signal(signal.SIGINT)
            master.wait(30)


if __name__ == "__main__":
    sys.exit(main())
