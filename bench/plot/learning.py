#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws agreement with the true map against the number of graph cuts and against time, as in
Figs. 10 and 11 of doi 10.1177/1687814017728839, from figures.csv of learning_bench.

  learning.py FIGURES.csv OUT.png [--measure "IoU mean"]
"""
import argparse
import collections
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

plt.style.use(str(pathlib.Path(__file__).with_name("legible.mplstyle")))

MARKERS = "osD^v<>"


def read_series(path, measure):
    """{method: [(iterations, map ms, value)]}"""
    series = collections.defaultdict(list)
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            point = (int(row["iterations"]), float(row["map ms"]), float(row[measure]))
            series[row["method"]].append(point)
    return series


def draw(series, measure, out):
    figure, (by_cuts, by_time) = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
    for marker, (method, points) in zip(MARKERS, series.items()):
        cuts, times, values = zip(*sorted(points))
        by_cuts.plot(cuts, values, marker=marker, label=method)
        by_time.plot(times, values, marker=marker, label=method)
    by_cuts.set_xlabel("graph cuts")
    by_cuts.set_xticks(range(1, 1 + max(p[0] for points in series.values() for p in points)))
    by_cuts.set_ylabel(measure)
    by_time.set_xlabel("time to the map, median [ms thread CPU]")
    by_time.set_xlim(left=0)
    for axes in (by_cuts, by_time):
        axes.grid(alpha=0.3)
    rows = -(-len(series) // 4)
    figure.legend(*by_cuts.get_legend_handles_labels(), loc="upper center", ncol=-(-len(series) // rows))
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.07 * rows))
    figure.savefig(out, dpi=120)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("figures")
    parser.add_argument("out")
    parser.add_argument("--measure", default="accuracy median", help="a column of the file")
    options = parser.parse_args()
    draw(read_series(options.figures, options.measure), options.measure, options.out)


main()
