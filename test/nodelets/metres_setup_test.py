#!/usr/bin/python3
"""From pixels to metres, as the README tells it: lens and platform of a camera, then the cell with both.

usage: metres_setup_test.py

The camera plays a picture of a chessboard. In place of camera_calibration's window, its service call is made.
"""
import os
import subprocess
import tempfile
import xmlrpc.client

import cv2
import yaml

from drawn_chessboard import COLUMNS, ROWS, SQUARE, camera_yaml, chessboard
from own_master import free_port, stop, wait_for

CALIBRATED, UNCALIBRATED = "0", "2"  # DetectedObjectArray: OK and UNCALIBRATED


def run(env, *command):
    print("$ " + " ".join(command), flush=True)
    subprocess.run(command, env=env, cwd=env["HOME"], check=True, timeout=60)


def start_cell(env, *arguments):
    home = env["HOME"]
    command = ["roslaunch", "-p", env["ROS_MASTER_URI"].rsplit(":", 1)[1], "mbncc_vision", "cell.launch",
               "source:=" + home + "/pictures", "camera_config:=camera_config.yaml", "library:=" + home + "/library"]
    return subprocess.Popen(command + list(arguments), env=env, cwd=home)


def status(env):
    """Of the next detections, as text; "" while there are none."""
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


def prepare(home):
    os.mkdir(os.path.join(home, "pictures"))
    cv2.imwrite(os.path.join(home, "pictures", "board.png"), chessboard())
    with open(os.path.join(home, "camera_config.yaml"), "w", encoding="utf-8") as file:
        yaml.safe_dump({"loop": True}, file)


def main():
    with tempfile.TemporaryDirectory() as home:
        prepare(home)
        env = dict(os.environ, HOME=home, ROS_HOME=home + "/ros", ROS_LOG_DIR=home + "/log",
                   ROS_MASTER_URI="http://localhost:%d" % free_port(), ROS_HOSTNAME="localhost")
        # rosrun finds no programs in a build folder inside the package.
        tool = os.path.join(env["CMAKE_PREFIX_PATH"].split(":")[0], "lib", "mbncc_vision", "mbncc")
        run(env, tool, "learn", "--library", "library", "--name", "corner", "--before",
            "pictures/board.png", "--roi", "280,200,90,90", "--allow-bad")
        cell = start_cell(env)
        try:
            wait_for(lambda: answers(env), cell, "the camera")
            assert status(env) == UNCALIBRATED
            set_camera_info(env)
            run(env, "rosrun", "mbncc_vision", "calibrate_platform", "--chessboard", "%dx%d" % (COLUMNS, ROWS),
                "--square", str(SQUARE), "--count", "2", "--out", "cell")
        finally:
            stop(cell)
        cell = start_cell(env, "platform:=cell")
        try:
            wait_for(lambda: answers(env), cell, "the camera again")
            wait_for(lambda: status(env) == CALIBRATED, cell, "metres")
        finally:
            stop(cell)


if __name__ == "__main__":
    main()
