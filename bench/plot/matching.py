#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws precision against recall over all thresholds, and F1 against time, from the figures.csv and
curves.csv that matching_bench writes.

  matching.py FOLDER OUT.png
"""
import argparse
import collections
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402

plt.style.use(str(pathlib.Path(__file__).with_name("legible.mplstyle")))


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def draw(curves, figures, out):
    figure, (by_recall, by_time) = plt.subplots(1, 2, figsize=(10, 4))
    for row in figures:
        points = curves[row["engine"]]
        by_recall.plot(*zip(*points), label=row["engine"])
        by_recall.plot(float(row["recall"]), float(row["precision"]), "ko", markersize=4)
        by_time.plot(float(row["ratio"]), float(row["F1"]), "o", markersize=9)
    by_recall.set(xlabel="recall", ylabel="precision", xlim=(0, 1.05), ylim=(0, 1.05))
    by_recall.set_title("over all thresholds; dots: the one in the table", fontsize="medium")
    by_time.set(xlabel="median time / one unrotated cv::matchTemplate", ylabel="F1", xscale="log")
    by_time.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    by_time.xaxis.set_major_formatter("{x:g}")
    by_time.xaxis.set_minor_formatter(NullFormatter())
    by_time.set_ylim(0, 1.05)
    for axes in (by_recall, by_time):
        axes.grid(alpha=0.3)
    figure.legend(*by_recall.get_legend_handles_labels(), loc="upper center", ncol=len(figures))
    figure.tight_layout(rect=(0, 0, 1, 0.93))
    figure.savefig(out, dpi=120)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("out")
    options = parser.parse_args()
    curves = collections.defaultdict(list)
    for row in read(options.folder / "curves.csv"):
        if row["precision"] != "-":
            curves[row["engine"]].append((float(row["recall"]), float(row["precision"])))
    figures = [r for r in read(options.folder / "figures.csv") if r["tag"] == "all"]
    draw(curves, [r for r in figures if r["recall"] != "-" and r["precision"] != "-"], options.out)


main()
