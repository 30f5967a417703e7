#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the similarity against a rotation deviation and against the background (Figs. 12 to 15 of
doi 10.1177/1687814017728839) from the files that paper_bench writes.

  paper.py FOLDER OUT.png
"""
import argparse
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

plt.style.use(str(pathlib.Path(__file__).with_name("legible.mplstyle")))

VARIANTS = {"mbncc": "MB-NCC", "incircle": "PP-NCC incircle", "excircle": "PP-NCC excircle"}


def read(path):
    """{elongation: rows}"""
    by_elongation = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            by_elongation.setdefault(row["elongation"], []).append(row)
    return by_elongation


def draw_rows(axes, rows, column, style):
    for name, label in VARIANTS.items():
        axes.plot([int(r[column]) for r in rows], [float(r[name]) for r in rows], style, label=label)
    axes.set(xlabel=column, ylim=(-0.7, 1.05))
    axes.grid(alpha=0.3)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("out")
    options = parser.parse_args()
    rotation = read(options.folder / "rotation.csv")
    backgrounds = read(options.folder / "backgrounds.csv")
    figure, grid = plt.subplots(2, len(rotation), figsize=(11, 6.5), sharey=True, squeeze=False)
    for (above, below), elongation in zip(grid.T, rotation):
        above.set_title("elongation " + elongation, fontsize="medium")
        draw_rows(above, rotation[elongation], "degrees", "-")
        draw_rows(below, backgrounds[elongation], "background", "o-")
    for axes in grid[:, 0]:
        axes.set_ylabel("similarity at the true place")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="upper center", ncol=len(VARIANTS))
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    figure.savefig(options.out, dpi=110)


main()
