#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A separate package is built against the install space, and its programs find the simulated cell's object.

usage: examples_test.py CMAKE SOURCE_FOLDER BUILD_FOLDER STAND_INS

STAND_INS is the prefix of message packages that stand in for those that are not installed.
"""
import glob
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "nodelets", "process"))
from install_space_test import environment  # noqa: E402
from own_master import free_port, stop, wait_for  # noqa: E402

MOST_LINES = 59
PROGRAMS = ("grasp_controller", "grasp_controller.py", "planning_scene.py", "print_poses.py", "vision_consumer.py")
LAUNCH = """<launch>
  <include file="$(find mbncc_vision)/launch/cell.launch">
    <arg name="simulated" value="true"/>
    <arg name="library" value="{home}/library"/>
    <arg name="platform_distance" value="0.3"/>
    <arg name="gripper_frame" value="gripper"/>
    <arg name="vision_msgs" value="true"/>
  </include>
  <rosparam ns="camera">{{neighbours: 0, auto_play: false, leg_time: 0.5, platform_distance: 0.3, object_height: 0.02}}</rosparam>
  <param name="matching/max_age" value="10.0"/>
  <node pkg="tf2_ros" type="static_transform_publisher" name="gripper_publisher"
        args="0.01 0.02 0.25 0 0 0 1 camera_optical_frame gripper"/>
  <node pkg="mbncc_vision_examples" type="grasp_controller" name="controller_in_cpp" output="screen"/>
  <node pkg="mbncc_vision_examples" type="grasp_controller.py" name="controller_in_python" output="screen"/>
  <node pkg="mbncc_vision_examples" type="planning_scene.py" name="planning_scene" output="screen"/>
  <node pkg="mbncc_vision_examples" type="vision_consumer.py" name="vision_consumer" output="screen"/>
</launch>
"""


def check_lengths(examples):
    for name in PROGRAMS:
        path = next(path for path in (examples + "/scripts/" + name, examples + "/src/" + name + ".cpp")
                    if os.path.exists(path))
        with open(path, encoding="utf-8") as file:
            lines = len(file.readlines())
        assert lines <= MOST_LINES, "%s has %d lines" % (path, lines)


def install(cmake, build, prefix):
    subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
    for library in glob.glob(build + "/devel/lib/libmbncc_vision_nodelets.so"):  # not installed without vision_msgs
        shutil.copy(library, prefix + "/lib")


def build_examples(cmake, examples, folder, prefix, env):
    subprocess.run([cmake, "-S", examples, "-B", folder, "-DCMAKE_INSTALL_PREFIX=" + prefix,
                    "-DPYTHON_EXECUTABLE=/usr/bin/python3"], env=env, check=True, stdout=subprocess.DEVNULL)
    subprocess.run([cmake, "--build", folder, "--target", "install"], env=env, check=True)


def main():
    cmake, source, build, stand_ins = sys.argv[1:]
    check_lengths(source + "/examples")
    with tempfile.TemporaryDirectory() as folder:
        prefix, home = folder + "/install", folder + "/home"
        os.makedirs(home)
        install(cmake, build, prefix)
        port = free_port()
        env = environment(prefix, home, port)
        modules = "/lib/python3/dist-packages"
        env["PYTHONPATH"] = ":".join([prefix + modules, stand_ins + modules, env.get("PYTHONPATH", "")])
        build_examples(cmake, source + "/examples", folder + "/build", prefix, env)
        with open(home + "/cell.launch", "w", encoding="utf-8") as file:
            file.write(LAUNCH.format(home=home))
        cell = subprocess.Popen(["roslaunch", "-p", str(port), home + "/cell.launch"], env=env)
        try:
            session = subprocess.Popen([sys.executable, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                                                     "examples_session.py")], env=env)
            wait_for(lambda: session.poll() is not None, cell, "the session")
            assert session.returncode == 0, "the session failed"
        finally:
            stop(cell)


if __name__ == "__main__":
    main()
