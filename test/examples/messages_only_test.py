#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds only the messages, as on a controller's computer, and the C++ example with them.

usage: messages_only_test.py CMAKE SOURCE_FOLDER
"""
import os
import subprocess
import sys
import tempfile

WITHOUT = ("OpenCV", "yaml-cpp", "nodelet", "image_transport", "Qt5", "rviz")
PYTHON = "-DPYTHON_EXECUTABLE=/usr/bin/python3"


def build(cmake, source, folder, prefix, *options):
    env = dict(os.environ, CMAKE_PREFIX_PATH=":".join([prefix, "/opt/ros/noetic", "/usr"]))
    subprocess.run([cmake, "-S", source, "-B", folder, "-DCMAKE_INSTALL_PREFIX=" + prefix, PYTHON, *options], env=env,
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run([cmake, "--build", folder, "--target", "install"], env=env, check=True, stdout=subprocess.DEVNULL)


def main():
    cmake, source = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        prefix = folder + "/install"
        missing = ["-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON" % package for package in WITHOUT]
        build(cmake, source, folder + "/messages", prefix, "-DMBNCC_MESSAGES_ONLY=ON", *missing)
        build(cmake, source + "/examples", folder + "/examples", prefix, *missing)
        modules = prefix + "/lib/python3/dist-packages"
        subprocess.run(["/usr/bin/python3", "-c", "from mbncc_vision.msg import DetectedObjectArray, LearnObjectAction"],
                       env=dict(os.environ, PYTHONPATH=modules + ":" + os.environ.get("PYTHONPATH", "")), check=True)
        assert os.path.exists(prefix + "/lib/mbncc_vision_examples/grasp_controller")


if __name__ == "__main__":
    main()
