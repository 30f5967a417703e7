#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the outputs of two builds of the command-line tool, to the last bit.

Both teach every case of the sets (from the pair of images, and from the region alone) and search the targets for the
taught object; a set whose cases share targets (`library`) is searched for all objects at once. Lessons, maps and
detections must be equal; only times may differ. Exit code 1 if anything differs. Cases: bench/README.md, "Data".

    bench/same_outputs.py OLD/mbncc NEW/mbncc SET [SET ...]
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PASSING = re.compile(r"^(ms|timings_ms|search_time|learned_at|file)$")  # times and temporary folders


def lasting(value):
    if isinstance(value, dict):
        return {key: lasting(entry) for key, entry in value.items() if not PASSING.match(key)}
    return [lasting(entry) for entry in value] if isinstance(value, list) else value


def output_of(command):
    """Exit code and standard output, without the times in JSON lines."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    try:
        return done.returncode, [lasting(json.loads(line)) for line in done.stdout.decode().splitlines()]
    except ValueError:
        return done.returncode, done.stdout


def lesson(tool, library, case, name, *more):
    region = ",".join((case / "roi.txt").read_text().split()[:4])
    return output_of([tool, "learn", "--library", library, "--name", name, "--before", case / "learn_before.png",
                      "--roi", region, "--allow-bad", "--json", *more])


def stored_map(tool, library, name, path):
    output_of([tool, "map", "--library", library, "--name", name, "--out", path])
    return path.read_bytes() if path.exists() else None


def outputs(tool, cases, folder):
    """{what: output} of one build."""
    result, library = {}, folder / "objects"
    for case in cases:
        name = re.sub(r"\W", "_", case.name)
        alone = folder / (name + "_alone")
        result[case, "pair"] = lesson(tool, library, case, name, "--after", case / "learn_after.png")
        result[case, "map"] = stored_map(tool, library, name, folder / (name + ".png"))
        result[case, "region"] = lesson(tool, alone, case, name)
        result[case, "map of the region"] = stored_map(tool, alone, name, folder / (name + "_alone.png"))
    shared = len({target.resolve() for case in cases for target in case.glob("target_*")}) < \
        sum(1 for case in cases for _ in case.glob("target_*"))
    for case in cases[:1] if shared else cases:
        targets = sorted(case.glob("target_*.png"))
        names = [] if shared else ["--name", re.sub(r"\W", "_", case.name)]
        if targets:
            result[case, "find"] = output_of([tool, "find", "--library", library, *names, "--json", *targets])
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    parser.add_argument("sets", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    compared = different = 0
    for one in arguments.sets:
        cases = sorted(path.parent for path in one.glob("*/learn_before.png"))
        with tempfile.TemporaryDirectory() as old, tempfile.TemporaryDirectory() as new:
            before = outputs(arguments.old, cases, pathlib.Path(old))
            after = outputs(arguments.new, cases, pathlib.Path(new))
        changed = [what for what in before if before[what] != after[what]]
        for case, what in changed:
            print("%s: %s differs" % (case, what))
        compared, different = compared + len(before), different + len(changed)
    print("%d of %d outputs differ" % (different, compared))
    return 1 if different or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
