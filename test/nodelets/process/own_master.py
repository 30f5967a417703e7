# SPDX-License-Identifier: BSD-3-Clause
"""Processes and a separate ROS master for a test, on a free port."""
import os
import signal
import socket
import subprocess
import sys
import time
import xmlrpc.client

DEADLINE = 60  # [s] generous; not reached unless a test fails


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def wait_for(predicate, process, what):
    deadline = time.monotonic() + DEADLINE
    while time.monotonic() < deadline:
        if process.poll() is not None:
            sys.exit("%s: the process ended with code %d" % (what, process.returncode))
        if predicate():
            return
        time.sleep(0.1)
    sys.exit("%s: not within %d s" % (what, DEADLINE))


def stop(process):
    process.send_signal(signal.SIGINT)
    try:
        process.wait(DEADLINE)
    except subprocess.TimeoutExpired:
        process.kill()
        sys.exit("%s did not end on SIGINT" % process.args)


def start_master(env):
    """The master of `env` as process and server. roslaunch and roscore time out after 10 s on a busy machine."""
    master = subprocess.Popen(["rosmaster", "--core", "-p", env["ROS_MASTER_URI"].rsplit(":", 1)[1]], env=env,
                              stdout=subprocess.DEVNULL)
    server = xmlrpc.client.ServerProxy(env["ROS_MASTER_URI"])
    wait_for(lambda: is_running(server), master, "rosmaster")
    return master, server


def is_running(master):
    try:
        return master.getPid("/test")[0] == 1
    except OSError:
        return False


def published(master):
    """Published topics as name -> publishers; {} while there is no master."""
    try:
        return dict(master.getSystemState("/test")[2][0])
    except OSError:
        return {}


def nodelet_program():
    return next(path for path in ("/usr/lib/nodelet/nodelet", "/opt/ros/noetic/lib/nodelet/nodelet")
                if os.path.exists(path))
