#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Memory, open files and threads over the images of long runs.

usage: soak.py OUT.png TITLE=FILE.csv ...   (files written by `soak` and by MBNCC_SOAK_CSV)
"""
import csv
import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

pyplot.style.use(str(pathlib.Path(__file__).with_name("legible.mplstyle")))

COLUMNS = {"resident_mb": "resident memory [MB]", "in_use_mb": "allocated [MB]", "files": "open files",
           "threads": "threads"}


def read(path):
    with open(path) as lines:
        rows = list(csv.DictReader(lines))
    return {key: [float(row[key]) for row in rows] for key in rows[0]}


def main():
    out, runs = sys.argv[1], [argument.split("=", 1) for argument in sys.argv[2:]]
    figure, axes = pyplot.subplots(1, len(runs), figsize=(4.2 * len(runs), 2.6), squeeze=False)
    for axis, (title, path) in zip(axes[0], runs):
        run = read(path)
        thousands = [frame / 1000 for frame in run["frame"]]
        for (column, label), style in zip(COLUMNS.items(), pyplot.rcParams["axes.prop_cycle"]):
            if column in run:
                axis.plot(thousands, run[column], label=label, linewidth=1, **style)
        axis.set_ylim(0)
        axis.set_xlabel("images [1000]")
        axis.set_title(title, fontsize=9)
        axis.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(out, dpi=90)


if __name__ == "__main__":
    main()
