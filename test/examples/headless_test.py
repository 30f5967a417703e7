#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot without a screen needs neither Qt nor RViz: package.xml leaves them out, and nothing else requires them.

usage: headless_test.py CMAKE SOURCE_FOLDER
"""
import os
import subprocess
import sys
import tempfile

from catkin_pkg.package import parse_package

OF_THE_CONSOLE = {"qtbase5-dev", "libqt5-widgets", "rviz"}


def dependencies(source, context):
    package = parse_package(source + "/package.xml")
    package.evaluate_conditions(context)
    return {each.name for kind in (package.build_depends, package.build_export_depends, package.exec_depends)
            for each in kind if each.evaluated_condition}


def main():
    cmake, source = sys.argv[1:]
    everything = dependencies(source, {"ROS_DISTRO": "noetic"})
    assert OF_THE_CONSOLE <= everything and "vision_msgs" in everything, everything
    headless = dependencies(source, {"ROS_DISTRO": "noetic", "MBNCC_HEADLESS": "1"})
    assert headless == everything - OF_THE_CONSOLE, everything - headless
    assert "vision_msgs" not in dependencies(source, {"ROS_DISTRO": "Debian"})
    with tempfile.TemporaryDirectory() as folder:
        options = ["MBNCC_BUILD_TESTS=OFF", "CMAKE_DISABLE_FIND_PACKAGE_Qt5=ON", "CMAKE_DISABLE_FIND_PACKAGE_rviz=ON",
                   "PYTHON_EXECUTABLE=/usr/bin/python3", "Python3_EXECUTABLE=/usr/bin/python3"]
        subprocess.run([cmake, "-S", source, "-B", folder] + ["-D" + option for option in options], check=True,
                       stdout=subprocess.DEVNULL)
        targets = subprocess.run([cmake, "--build", folder, "--target", "help"], check=True, text=True,
                                 stdout=subprocess.PIPE).stdout
        assert "mbncc_nodelets" in targets and "mbncc_console_autogen" not in targets, targets
        assert not os.path.exists(folder + "/stand_ins"), "nothing is generated without tests"


if __name__ == "__main__":
    main()
