#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From pixels to metres, as in the README: lens and platform of a camera, then the cell with both.

usage: metres_setup_test.py

The camera plays an image of a chessboard. The test makes the service call of camera_calibration instead of using its
window.
"""
import os
import re
import subprocess
import sys
import tempfile
import xmlrpc.client

import cv2
import numpy as np
import yaml

from drawn_chessboard import COLUMNS, ROWS, SQUARE, camera_yaml, chessboard

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "process"))
from own_master import free_port, start_master, stop, wait_for  # noqa: E402

CALIBRATED, UNCALIBRATED = "0", "2"  # DetectedObjectArray: OK and UNCALIBRATED


def run(env, *command):
    print("$ " + " ".join(command), flush=True)
    subprocess.run(command, env=env, cwd=env["HOME"], check=True, timeout=60)


def start_cell(env, *arguments):
    home = env["HOME"]
    command = ["roslaunch", "-p", env["ROS_MASTER_URI"].rsplit(":", 1)[1], "mbncc_vision", "cell.launch",
               "source:=" + home + "/images", "camera_config:=camera_config.yaml", "library:=" + home + "/library"]
    return subprocess.Popen(command + list(arguments), env=env, cwd=home)


def status(env):
    """Status of the next detections as text; "" if there are none."""
    heard = subprocess.run(["rostopic", "echo", "-n", "1", "/detected_objects/status"], env=env, timeout=60,
                           capture_output=True, text=True, check=False)
    return heard.stdout.partition("\n")[0]


def answers(env):
    try:
        return "/set_camera_info" in dict(
            xmlrpc.client.ServerProxy(env["ROS_MASTER_URI"]).getSystemState("/test")[2][2])
    except OSError:
        return False


def set_camera_info(env):
    stored = yaml.safe_load(camera_yaml())
    matrices = {"K": "camera_matrix", "D": "distortion_coefficients", "R": "rectification_matrix",
                "P": "projection_matrix"}
    info = {letter: stored[name]["data"] for letter, name in matrices.items()}
    info.update(width=640, height=480, distortion_model="plumb_bob")
    run(env, "rosservice", "call", "/set_camera_info", yaml.safe_dump({"camera_info": info}, default_flow_style=True))


def calibrate(env, *arguments):
    run(env, "rosrun", "mbncc_vision", "calibrate_platform", "--chessboard", "%dx%d" % (COLUMNS, ROWS), "--square",
        str(SQUARE), "--count", "2", *arguments)


def published_pose(folder):
    """Rotation and position that platform.launch publishes, and its frames."""
    with open(os.path.join(folder, "platform.launch"), encoding="utf-8") as file:
        words = re.search('args="([^"]*)"', file.read()).group(1).split()
    numbers = [float(word) for word in words[:7]]
    turn = 2 * np.arctan2(np.linalg.norm(numbers[3:6]), numbers[6])
    axis = np.array(numbers[3:6]) / np.linalg.norm(numbers[3:6])
    return cv2.Rodrigues(axis * turn)[0], np.array(numbers[:3]), words[7:]


def check_fixed_frame(env):
    """The camera is mounted on a robot: rotated by 90 degrees about its axis, 1 m beside the base and 2 m above it."""
    robot = subprocess.Popen(["rosrun", "tf2_ros", "static_transform_publisher", "1", "0", "2", "0", "0",
                              "0.70710678", "0.70710678", "base_link", "camera_optical_frame"], env=env)
    try:
        calibrate(env, "--out", "arm", "--fixed-frame", "base_link")
    finally:
        stop(robot)
    rotation, place, _ = published_pose(env["HOME"] + "/cell")
    turned, moved, frames = published_pose(env["HOME"] + "/arm")
    quarter = cv2.Rodrigues(np.array([0, 0, np.pi / 2]))[0]
    assert frames == ["base_link", "platform"], frames
    assert np.allclose(turned, quarter @ rotation, atol=0.01), turned
    assert np.allclose(moved, quarter @ place + [1, 0, 2], atol=0.002), moved


def prepare(home):
    os.mkdir(os.path.join(home, "images"))
    cv2.imwrite(os.path.join(home, "images", "board.png"), chessboard())
    with open(os.path.join(home, "camera_config.yaml"), "w", encoding="utf-8") as file:
        yaml.safe_dump({"loop": True}, file)


def set_up_metres(env):
    cell = start_cell(env)
    try:
        wait_for(lambda: answers(env), cell, "the camera")
        assert status(env) == UNCALIBRATED
        set_camera_info(env)
        calibrate(env, "--out", "cell")
        check_fixed_frame(env)
    finally:
        stop(cell)
    cell = start_cell(env, "platform:=cell")
    try:
        wait_for(lambda: answers(env), cell, "the camera again")
        wait_for(lambda: status(env) == CALIBRATED, cell, "metres")
    finally:
        stop(cell)


def main():
    with tempfile.TemporaryDirectory() as home:
        prepare(home)
        env = dict(os.environ, HOME=home, ROS_HOME=home + "/ros", ROS_LOG_DIR=home + "/log",
                   ROS_MASTER_URI="http://localhost:%d" % free_port(), ROS_HOSTNAME="localhost")
        # rosrun does not find programs in a build folder inside the package.
        tool = os.path.join(env["CMAKE_PREFIX_PATH"].split(":")[0], "lib", "mbncc_vision", "mbncc")
        run(env, tool, "learn", "--library", "library", "--name", "corner", "--before",
            "images/board.png", "--roi", "280,200,90,90", "--allow-bad")
        master, _ = start_master(env)
        try:
            set_up_metres(env)
        finally:
            stop(master)


if __name__ == "__main__":
    main()
