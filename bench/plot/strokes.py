#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plots the effect of strokes on bad maps, from strokes.csv of strokes_bench.

  strokes.py STROKES.csv OUT.png
"""
import argparse
import collections
import csv
import pathlib
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

plt.style.use(str(pathlib.Path(__file__).with_name("legible.mplstyle")))


def read_maps(path):
    """The IoUs of each map: as learned, and after each stroke."""
    maps = collections.defaultdict(list)
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            maps[row["set"], row["map"]].append(float(row["IoU"]))
    return list(maps.values())


def draw_first_stroke(axes, maps):
    axes.plot([0, 1], [0, 1], color="grey", linewidth=1)
    axes.scatter([m[0] for m in maps], [m[1] for m in maps], s=12, alpha=0.6)
    lowest = min(min(m[:2]) for m in maps) - 0.02
    axes.set_xlim(lowest, 1)
    axes.set_ylim(lowest, 1)
    axes.set_xlabel("IoU as learned")
    axes.set_ylabel("IoU after a stroke")


def draw_strokes(axes, maps):
    strokes = range(max(len(m) for m in maps))
    after = [sorted(m[min(k, len(m) - 1)] for m in maps) for k in strokes]
    tenth = len(maps) // 10
    axes.fill_between(strokes, [v[tenth] for v in after], [v[-1 - tenth] for v in after], alpha=0.2,
                      label="all but a tenth at either end")
    axes.plot(strokes, [statistics.mean(v) for v in after], marker="o", label="mean of %d maps" % len(maps))
    axes.set_xticks(strokes)
    axes.set_xlabel("strokes")
    axes.set_ylabel("IoU")
    axes.legend(loc="lower right")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("strokes")
    parser.add_argument("out")
    options = parser.parse_args()
    maps = read_maps(options.strokes)
    figure, (first, more) = plt.subplots(1, 2, figsize=(8, 3.6))
    draw_first_stroke(first, maps)
    draw_strokes(more, maps)
    for axes in (first, more):
        axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(options.out, dpi=110)


main()
