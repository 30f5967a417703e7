#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The ROS master dies and comes back: clients that subscribe afterwards get images and detections.

usage: master_restart_test.py
"""
import os
import signal
import subprocess
import tempfile
import time

from own_master import free_port, nodelet_program, published, start_master, stop, wait_for

CAMERA = ["mbncc_vision/SimulatedCameraNodelet", "__name:=camera", "_width:=160", "_height:=120",
          "_object_diameter:=40", "_neighbours:=0"]


def services(server):
    return dict(server.getSystemState("/master_restart_test")[2][2])


def kill(process):
    process.send_signal(signal.SIGKILL)
    process.wait()


def hear(topic, env, messages=1):
    """Messages received by a new subscriber."""
    subprocess.run(["rostopic", "echo", "-n", str(messages), "--noarr", topic], env=env, check=True, timeout=60,
                   stdout=subprocess.DEVNULL)


def main():
    with tempfile.TemporaryDirectory() as home:
        env = dict(os.environ, HOME=home, ROS_LOG_DIR=os.path.join(home, "log"),
                   ROS_MASTER_URI="http://localhost:%d" % free_port(), ROS_HOSTNAME="localhost")
        matching = ["mbncc_vision/MatchingNodelet", "__name:=matching",
                    "_library_path:=" + os.path.join(home, "library")]
        master, server = start_master(env)
        nodelets = [subprocess.Popen([nodelet_program(), "standalone"] + arguments, env=env)
                    for arguments in (CAMERA, matching)]
        try:
            wait_for(lambda: {"/image_raw", "/detected_objects"} <= set(published(server)),
                     nodelets[0], "first registration")
            wait_for(lambda: "/find_objects" in services(server), nodelets[1], "first registration")
            # Reports arrive once per second; the nodelets check the master at the same rate.
            hear("/diagnostics", env, messages=8)
            kill(master)
            master, server = start_master(env)
            since = time.monotonic()
            wait_for(lambda: {"/image_raw", "/detected_objects"} <= set(published(server)) and
                     "/find_objects" in services(server), nodelets[0], "new registration")
            hear("/image_raw", env)
            hear("/detected_objects", env)
            print("heard again after %.1f s" % (time.monotonic() - since))
        finally:
            for process in nodelets:
                stop(process)
            kill(master)


if __name__ == "__main__":
    main()
