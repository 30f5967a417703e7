#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every nodelet of the package loads from the install space; that for vision_msgs reports if they are missing.

usage: install_space_test.py CMAKE BUILD_FOLDER

Installs into a temporary prefix, starts a master on a separate port and loads each nodelet of
the installed plugin descriptions in an environment that contains only the system and that prefix.
"""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import xmlrpc.client

import rospkg

from own_master import free_port, nodelet_program, published, stop, wait_for

PACKAGE = "mbncc_vision"
ARGUMENTS = {PACKAGE + "/CameraNodelet": ["_source:=/nowhere"]}  # arguments without a usable default


def environment(prefix, home, port):
    """The environment after sourcing the install space, without anything from the build."""
    build_free = {key: value for key, value in os.environ.items()
                  if key not in ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "PYTHONPATH",
                                 "ROS_PACKAGE_PATH")}
    roots = [path for path in ("/opt/ros/noetic", "/usr") if os.path.isdir(path)]
    build_free.update(
        PATH="/usr/bin:" + os.environ.get("PATH", ""), HOME=home, ROS_HOSTNAME="localhost",
        ROS_MASTER_URI="http://localhost:%d" % port, ROS_LOG_DIR=os.path.join(home, "log"),
        CMAKE_PREFIX_PATH=":".join([prefix] + roots),
        LD_LIBRARY_PATH=":".join(os.path.join(root, "lib") for root in [prefix] + roots),
        ROS_PACKAGE_PATH=":".join(os.path.join(root, "share") for root in [prefix] + roots))
    if os.path.isdir("/opt/ros/noetic"):
        build_free["PYTHONPATH"] = "/opt/ros/noetic/lib/python3/dist-packages"
    return build_free


def load(name, env, master):
    """Loads one nodelet; it must start, keep running and end by itself on SIGINT. Returns its output."""
    node = "probe_" + name.split("/")[1]  # parameters remain on the server under this name
    command = [nodelet_program(), "standalone", name, "__name:=" + node] + ARGUMENTS.get(name, [])
    process = subprocess.Popen(command, env=env, stderr=subprocess.PIPE, text=True)
    # Each nodelet publishes diagnostics or images once it is initialised.
    wait_for(lambda: any("/" + node in nodes and topic in ("/diagnostics", "/image_raw")
                         for topic, nodes in published(master).items()), process, name)
    stop(process)
    print("%s: loaded" % name, flush=True)
    return process.stderr.read()


def names_of(plugins):
    return [plugin.get("name") for plugin in xml.etree.ElementTree.parse(plugins).iter("class")]


def main():
    cmake, build = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as prefix, tempfile.TemporaryDirectory() as home:
        os.mkdir(os.path.join(home, ".ros"))
        subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True,
                       stdout=subprocess.DEVNULL)
        share = os.path.join(prefix, "share", PACKAGE)
        for wanted in ("package.xml", "launch/demo.launch", "config/matching.yaml"):
            assert os.path.exists(os.path.join(share, wanted)), wanted + " is not installed"
        env = environment(prefix, home, free_port())
        master = xmlrpc.client.ServerProxy(env["ROS_MASTER_URI"])
        core = subprocess.Popen(["roscore", "-p", env["ROS_MASTER_URI"].rsplit(":", 1)[1]],
                                env=env, stdout=subprocess.DEVNULL)
        try:
            wait_for(lambda: "/rosout_agg" in published(master), core, "roscore")
            names = names_of(os.path.join(share, "nodelet_plugins.xml"))
            assert len(names) >= 3, "the plugin description names too few nodelets"
            for name in names:
                load(name, env, master)
            said = load(*names_of(os.path.join(share, "vision_plugins.xml")), env, master)
            missing = "vision_msgs" not in rospkg.RosPack().list()
            assert said.count("built without vision_msgs") == (1 if missing else 0), said
        finally:
            stop(core)


if __name__ == "__main__":
    main()
