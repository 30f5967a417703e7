#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""config/diagnostic_aggregator.yaml finds the reports of every nodelet, by their names on /diagnostics.

usage: diagnostics_test.py
"""
import os
import subprocess
import tempfile

import rospkg
import rospy
import yaml
from diagnostic_msgs.msg import DiagnosticArray

from own_master import free_port, stop, wait_for


def patterns():
    path = os.path.join(rospkg.RosPack().get_path("mbncc_vision"), "config", "diagnostic_aggregator.yaml")
    with open(path, encoding="utf-8") as file:
        return yaml.safe_load(file)["analyzers"]["vision"]["contains"]


def main():
    with tempfile.TemporaryDirectory() as home:
        port = free_port()
        os.environ.update(HOME=home, ROS_HOME=home, ROS_LOG_DIR=home, ROS_NAMESPACE="left",
                          ROS_MASTER_URI="http://localhost:%d" % port)
        cell = subprocess.Popen(["roslaunch", "-p", str(port), "mbncc_vision", "cell.launch", "simulated:=true",
                                 "rectify:=true", "vision_msgs:=true", "library:=" + home + "/library"])
        try:
            # The master is roslaunch's; init_node waits for it.
            rospy.init_node("diagnostics_test", disable_signals=True)
            names = set()
            rospy.Subscriber("/diagnostics", DiagnosticArray,
                             lambda array: names.update(status.name for status in array.status))
            wait_for(lambda: all(any(pattern in name for name in names) for pattern in patterns()), cell,
                     "a report for each of %s" % patterns())
            strangers = {name for name in names if not any(pattern in name for pattern in patterns())}
            assert not strangers, strangers
        finally:
            stop(cell)


if __name__ == "__main__":
    main()
