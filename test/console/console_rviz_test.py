#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""RViz never gets a file of the package, because it would offer to overwrite it.

usage: console_rviz_test.py PATH/TO/console_rviz
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rospkg
from roslaunch.config import ROSLaunchConfig
from roslaunch.xmlloader import XmlLoader

SCRIPT = sys.argv.pop(1)
PACKAGE = pathlib.Path(rospkg.RosPack().get_path("mbncc_vision"))
SHIPPED = PACKAGE / "config" / "console.rviz"


class ConsoleRVizTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        stand_in = self.folder / "bin" / "rviz"
        stand_in.parent.mkdir()
        stand_in.write_text("#!/bin/sh\necho \"$@\"\n")
        stand_in.chmod(0o755)

    def start(self, *arguments):
        """The arguments with which RViz is called."""
        env = dict(os.environ, ROS_HOME=str(self.folder), PATH=str(self.folder / "bin") + ":" + os.environ["PATH"])
        return subprocess.run([SCRIPT] + [str(a) for a in arguments], env=env, stdout=subprocess.PIPE, text=True,
                              check=True).stdout.split()

    def test_the_package_provides_a_copy(self):
        flag, config, *others = self.start(SHIPPED, "-f", "base", "__name:=console")
        self.assertEqual((flag, others), ("-d", ["-f", "base", "__name:=console"]))
        self.assertEqual(pathlib.Path(config), self.folder / "mbncc_vision" / "console.rviz")
        self.assertEqual(pathlib.Path(config).read_text(), SHIPPED.read_text())

    def test_what_was_saved_stays_until_the_package_is_newer(self):
        copy = self.folder / "mbncc_vision" / "console.rviz"
        self.assertEqual(self.start(SHIPPED)[1], str(copy))
        copy.write_text("saved")
        self.start(SHIPPED)
        self.assertEqual(copy.read_text(), "saved")
        os.utime(str(copy), (0, 0))
        self.start(SHIPPED)
        self.assertEqual(copy.read_text(), SHIPPED.read_text())

    def test_a_file_of_the_operator_is_used_unchanged(self):
        own = self.folder / "own.rviz"
        own.write_text("own")
        self.assertEqual(self.start(own)[1], str(own))

    def test_no_launch_file_starts_rviz_itself(self):
        started = []
        for name, arguments in (("console.launch", ["rviz:=true"]), ("demo.launch", [])):
            config = ROSLaunchConfig()
            XmlLoader().load(str(PACKAGE / "launch" / name), config, argv=arguments, verbose=False)
            started += [node.type for node in config.nodes if "rviz" in node.type]
        self.assertEqual(started, ["console_rviz"] * 2)


unittest.main()
