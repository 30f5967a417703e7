#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A library that rsync copies to another cell can be read there at any time: no partial object, nothing quarantined.

usage: rsync_test.py PATH/TO/mbncc
"""
import os
import subprocess
import sys
import tempfile
import threading

ROUNDS = 10
NAMES = ["part1", "part2"]


def run(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


def main():
    tool = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        taught, copied = folder + "/taught", folder + "/copied"
        run(tool, "simulate", "--out", folder, "--count", "1")
        for name in NAMES:
            run(tool, "learn", "--library", taught, "--name", name, "--allow-bad", "--before", folder + "/before.png",
                "--after", folder + "/after.png")

        def copy():
            run("rsync", "-a", "--exclude", ".*", taught + "/", copied + "/")

        def teach_and_copy():
            for number in range(ROUNDS):
                run(tool, "edit", "--library", taught, "--name", "part1", "--symmetry", "none" if number % 2 else "2")
                copy()

        copy()
        writer = threading.Thread(target=teach_and_copy)
        writer.start()
        reads = 0
        while writer.is_alive() or reads == 0:
            listed = run(tool, "list", "--library", copied)
            assert all(name in listed for name in NAMES), listed
            reads += 1
        writer.join()
        assert not os.path.exists(copied + "/.quarantine")
        assert "revision %d" % (ROUNDS + 1) in run(tool, "show", "--library", copied, "--name", "part1")
        print("%d reads while %d revisions came" % (reads, ROUNDS))


if __name__ == "__main__":
    main()
