#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks which files learning and matching change on disk for valid and invalid requests.

usage: touched_files_test.py

Both run under strace with a separate master. They may not start programs, and may create, write, rename or remove
files only in the library and in ROS's log folder.
"""
import os
import re
import subprocess
import sys
import tempfile
import xmlrpc.client

from own_master import free_port, nodelet_program, published, stop, wait_for

NODELETS = ("LearningNodelet", "MatchingNodelet")
NAMES = ["../../x", "/etc/x", "a/b", "x\n", "part"]
WRITING = re.compile(r"O_(WRONLY|RDWR|CREAT|TRUNC|APPEND)")
CHANGING = re.compile(r"^(rename|unlink|mkdir|rmdir|link|symlink|truncate|mknod|chmod|chown|creat)")
CALL = re.compile(r"^\d+ +(\w+)\((.*)\) += +(-?\d+)")


def clients(home):
    """Sends requests like another client; runs in the environment of the test's master."""
    import actionlib
    import numpy
    import rospy
    from mbncc_vision.msg import LearnObjectAction, LearnObjectGoal
    from mbncc_vision.srv import EditObject, EditObjectRequest, FindObjects, FindObjectsRequest
    from sensor_msgs.msg import Image

    rospy.init_node("peer", anonymous=True)
    random = numpy.random.RandomState(1)
    after = random.randint(90, 110, (120, 160, 3)).astype(numpy.uint8)
    before = after.copy()
    before[40:80, 50:100] = random.randint(0, 255, (40, 50, 3))

    def image(pixels):
        return Image(height=120, width=160, encoding="bgr8", step=480, data=pixels.tobytes())

    teacher = actionlib.ActionClient("learn_object", LearnObjectAction)
    teacher.wait_for_server()
    edit = rospy.ServiceProxy("edit_object", EditObject)
    find = rospy.ServiceProxy("find_objects", FindObjects)
    edit.wait_for_service()
    find.wait_for_service()
    stored = False
    for name in NAMES:
        goal = LearnObjectGoal(name=name, before=image(before), after=image(after), allow_bad=True)
        handle = teacher.send_goal(goal)
        while handle.get_comm_state() != actionlib.CommState.DONE:
            rospy.rostime.wallsleep(0.05)
        stored = stored or handle.get_result().error_code == 0
        find(FindObjectsRequest(names=[name], image=image(before)))
        for command in (EditObjectRequest.RENAME, EditObjectRequest.DELETE, EditObjectRequest.RESTORE):
            edit(EditObjectRequest(name=name, new_name="../" + name, command=command))
    assert stored, "the sound lesson was refused"
    assert os.path.exists(os.path.join(home, "library", "part.png"))


def violations(log, allowed):
    with open(log, errors="replace") as lines:
        for line in lines:
            call = CALL.match(line)
            if not call or int(call.group(3)) < 0:
                continue
            name, arguments, _ = call.groups()
            paths = re.findall(r'"((?:[^"\\]|\\.)*)"', arguments)
            writes = name.startswith("open") and WRITING.search(arguments)
            if name.startswith("exec") or ((writes or CHANGING.match(name)) and not all(
                    path.startswith(allowed) for path in paths)):
                yield line.strip()


def start(name, home, env):
    log = os.path.join(home, name + ".strace")
    traced = ["strace", "-f", "-qq", "-s", "300", "-e", "trace=%file", "-o", log, nodelet_program(),
              "standalone", "mbncc_vision/" + name, "__name:=" + name.lower(),
              "_library_path:=" + os.path.join(home, "library")]
    return subprocess.Popen(traced, env=env), log


def main():
    with tempfile.TemporaryDirectory() as home:
        env = dict(os.environ, HOME=home, ROS_HOME=os.path.join(home, "log"), ROS_HOSTNAME="localhost",
                   ROS_LOG_DIR=os.path.join(home, "log"),
                   ROS_MASTER_URI="http://localhost:%d" % free_port())
        os.environ.update(env)
        server = xmlrpc.client.ServerProxy(env["ROS_MASTER_URI"])
        core = subprocess.Popen(["roscore", "-p", env["ROS_MASTER_URI"].rsplit(":", 1)[1]], env=env,
                                stdout=subprocess.DEVNULL)
        traced = []
        try:
            wait_for(lambda: "/rosout_agg" in published(server), core, "roscore")
            traced.extend(start(name, home, env) for name in NODELETS)
            clients(home)
            for name in NODELETS:
                # strace does not forward signals.
                node = server.lookupNode("/test", "/" + name.lower())[2]
                xmlrpc.client.ServerProxy(node).shutdown("/test", "the test is over")
            for process, _ in traced:
                process.wait(60)
        finally:
            for process, _ in traced:
                if process.poll() is None:
                    process.kill()
            stop(core)
        allowed = (os.path.join(home, "library"), os.path.join(home, "log"), "/dev/null", "/dev/shm/")
        found = []
        for process, log in traced:
            started = 0
            for line in violations(log, allowed):
                # The first one is the start of the program by strace.
                started += " exec" in line
                if started != 1 or " exec" not in line:
                    found.append(line)
        if found:
            sys.exit("touched outside the library:\n" + "\n".join(found))


if __name__ == "__main__":
    main()
