#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Searches photographs for objects that were taught in others, and prints a table by source.

SET is a folder that make_search_cases.py has made. Each object is taught by its true map
(`mbncc learn --map`) and the symmetry that its tag `sym:` [degrees] declares, otherwise with the
default settings, and searched in its targets (`mbncc find`). A detection is right if it is within
max(5 px, 5 % of the diameter) and 6 degrees, modulo the symmetry, of an instance that no better one
has claimed; otherwise it is wrong, unless it lies in an area of ignore.csv (an object that is
tilted, of another size, or shares part of its print with the taught one); graspable detections
there have a separate column. Further arguments are passed to `mbncc find`.
OUT.json holds every detection.
"""
import argparse
import csv
import json
import math
import statistics
import subprocess
import tempfile
from collections import defaultdict
from pathlib import Path

LEAST_PX, PART_OF_DIAMETER, DEGREES = 5, 0.05, 6


def rows_of(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def by_target(case, name):
    rows = defaultdict(list)
    if (case / name).is_file():
        for row in rows_of(case / name):
            rows[row["target"]].append(row)
    return rows


def run(command):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True, check=True).stdout


def teach(mbncc, library, case, period):
    symmetry = {0: "round", 360: "auto"}.get(period) or str(round(360 / period))
    told = run([mbncc, "learn", "--library", library, "--name", "object", "--before", case / "learn_before.png",
                "--map", case / "gt_mask.png", "--symmetry", symmetry, "--json", "--allow-bad"])
    return json.loads(told[told.index("{"):])


def at_reference(found, shift):
    """Position of the case's reference point at the detection; `shift` [px] is its offset from the object's."""
    angle = math.radians(found["theta_deg"])
    across, down = shift
    return (found["x"] + math.cos(angle) * across - math.sin(angle) * down,
            found["y"] + math.sin(angle) * across + math.cos(angle) * down)


def turn_between(a, b, period):
    return 0 if period == 0 else abs((a - b + period / 2) % period - period / 2)


def judge(found, instances, ignored, tolerance, period):
    """'right', 'wrong' or 'ignored'; a right detection claims its instance."""
    near = [one for one in instances
            if math.hypot(found["place"][0] - float(one["x"]), found["place"][1] - float(one["y"])) <= tolerance and
            turn_between(found["theta_deg"], float(one["theta_deg"]), period) <= DEGREES]
    if near:
        instances.remove(near[0])
        return "right"
    inside = any(math.hypot(found["place"][0] - float(one["x"]), found["place"][1] - float(one["y"])) <=
                 float(one["radius_px"]) for one in ignored)
    return "ignored" if inside else "wrong"


def search(mbncc, case, arguments):
    """For each target of a case: the detections with their verdicts, and the number of missed instances."""
    tags = json.loads((case / "meta.json").read_text())["tags"]
    period = next((float(tag[4:]) for tag in tags if tag.startswith("sym:")), 360)
    targets = [case / (row["target"] + ".png") for row in rows_of(case / "targets.csv")]
    instances, ignored = by_target(case, "gt.csv"), by_target(case, "ignore.csv")
    with tempfile.TemporaryDirectory() as library:
        taught = teach(mbncc, library, case, period)
        lines = run([mbncc, "find", "--library", library, "--threads", "1", "--json", *arguments, *targets])
    if len(lines.splitlines()) != len(targets):
        raise SystemExit("%s: %d of %d targets were searched" % (case, len(lines.splitlines()), len(targets)))
    reference = [float(word) for word in (case / "ref.txt").read_text().split()]
    shift = (reference[0] - taught["reference"]["x"], reference[1] - taught["reference"]["y"])
    tolerance = max(LEAST_PX, PART_OF_DIAMETER * 2 * taught["radius"])
    results = []
    for line in lines.splitlines():
        result = json.loads(line)
        name = Path(result["image"]).stem
        left = instances[name]
        for found in sorted(result["objects"], key=lambda one: -one["score"]):
            found["place"] = at_reference(found, shift)
            found["verdict"] = judge(found, left, ignored[name], tolerance, period)
        results.append({"source": case.parent.name, "case": case.name, "target": name, "ms": result["ms"],
                        "missed": len(left), "objects": result["objects"]})
    return results


def row(name, results):
    def count(verdict, graspable=False):
        return sum(found["verdict"] == verdict and (found["graspable"] or not graspable)
                   for result in results for found in result["objects"])
    right, wrong, missed = count("right"), count("wrong"), sum(result["missed"] for result in results)
    return "| %s | %d | %.3f | %.3f | %d | %d | %d | %.0f |" % (
        name, right + missed, right / max(1, right + missed), right / max(1, right + wrong), count("right", True),
        count("wrong", True), count("ignored", True), statistics.median(result["ms"] for result in results))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mbncc", metavar="MBNCC", type=Path, help="the built tool")
    parser.add_argument("set", metavar="SET", type=Path)
    parser.add_argument("--out", metavar="OUT.json", type=Path)
    options, arguments = parser.parse_known_args()
    cases = sorted(path.parent for path in options.set.glob("*/*/gt.csv"))
    if not cases:
        parser.error("no SOURCE/CASE/gt.csv below %s" % options.set)
    results = [result for case in cases for result in search(options.mbncc, case, arguments)]
    print("| source | instances | recall | precision | graspable right | wrong | ignored | ms median |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    sources = defaultdict(list)
    for result in results:
        sources[result["source"]].append(result)
    for source, own in sources.items():
        print(row(source, own))
    print(row("all", results))
    if options.out:
        options.out.write_text(json.dumps(results))


if __name__ == "__main__":
    main()
