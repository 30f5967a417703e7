#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The systemd unit's command starts the cell with an empty state folder.

usage: unit_file_test.py

Runs the command and environment of docs/mbncc_vision.service in a folder that replaces /var/lib/mbncc.
"""
import configparser
import os
import re
import shlex
import subprocess
import tempfile
import xmlrpc.client

from own_master import free_port, published, stop, wait_for

UNIT = os.path.join(os.path.dirname(__file__), "../../../docs/mbncc_vision.service")


def service(state):
    """Environment and roslaunch command of the unit for another state folder."""
    unit = configparser.ConfigParser(strict=False, interpolation=None)
    unit.optionxform = str
    unit.read(UNIT)
    section = unit["Service"]
    assert section["StateDirectory"] == "mbncc"
    here = {key: section[key].replace("/var/lib/mbncc", state) for key in ("Environment", "ExecStart")}
    command = re.search(r"exec (roslaunch .*)'$", here["ExecStart"]).group(1)
    return dict(entry.split("=", 1) for entry in shlex.split(here["Environment"])), shlex.split(command)


def main():
    with tempfile.TemporaryDirectory() as state:
        environment, command = service(state)
        port = free_port()
        environment.update(ROS_MASTER_URI="http://localhost:%d" % port, ROS_IP="127.0.0.1")
        env = dict(os.environ, **environment)
        env.pop("ROS_HOSTNAME", None)
        env.pop("ROS_LOG_DIR", None)
        core = subprocess.Popen(["roscore", "-p", str(port)], env=env, stdout=subprocess.DEVNULL)
        cell = subprocess.Popen(command, env=env)
        try:
            master = xmlrpc.client.ServerProxy(env["ROS_MASTER_URI"])
            wait_for(lambda: {"/learn_object/status", "/detected_objects", "/image_raw"} <= set(published(master)),
                     cell, "the cell")
        finally:
            stop(cell)
            stop(core)


if __name__ == "__main__":
    main()
