# SPDX-License-Identifier: BSD-3-Clause
"""Processes and a separate ROS master of a test, on a free port."""
import os
import signal
import socket
import subprocess
import sys
import time

DEADLINE = 60  # [s] generous; nothing waits for it when all is well


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


def published(master):
    """Topics that somebody publishes, as name -> publishers; {} while there is no master."""
    try:
        return dict(master.getSystemState("/test")[2][0])
    except OSError:
        return {}


def nodelet_program():
    return next(path for path in ("/usr/lib/nodelet/nodelet", "/opt/ros/noetic/lib/nodelet/nodelet")
                if os.path.exists(path))
