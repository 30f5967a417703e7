#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits the weights of log_odds() (src/core/matching/evidence/evidence.cpp) to the rows of evidence_rows by logistic regression.

usage: fit.py ROWS.csv [--plot reliability.png]

Prints the weights and their quality by cross-validation: each set is judged by weights fitted to all others.
"""
import argparse
import csv
import pathlib
import sys

import numpy as np

READ = ["contour_coverage", "gradient", "trimmed_residual", "histogram", "shading_free_ncc", "texture"]  # columns of the file
NAMES = READ + ["cast_penalty", "log_area", "outside", "one"]
OF_SMALL = ["one", "contour_coverage", "gradient", "trimmed_residual", "histogram", "shading_free_ncc"]  # with weights for small objects
LARGE_AREA, SMALL_AREA = 1800, 700  # as in evidence.cpp
EDGES = [0.02, 0.15, 0.35, 0.65, 0.85, 0.98]  # limits of the probability ranges in the reliability table
RIDGE = 0.05  # rows are many and features are correlated: prevents large weights of opposite sign


def read_rows(path):
    """Features, the other parts of the odds, correctness, sets, and the weights with which the rows were made."""
    rows = list(csv.DictReader(open(path)))
    number = lambda name: np.array([float(row[name]) for row in rows])
    features = {name: number(name) for name in READ}
    cast = number("cast")
    features["cast_penalty"] = np.where(cast > 0, 2 + 60 * cast**2, 0)  # as in evidence.cpp
    features["log_area"] = np.log(np.minimum(number("area"), LARGE_AREA))
    features["outside"], features["one"] = 1 - number("compared"), np.ones(len(rows))
    small = np.maximum(0, np.log(SMALL_AREA / number("area")))
    columns = np.stack([features[name] for name in NAMES] + [small * features[name] for name in OF_SMALL], 1)
    odds = number("odds")
    current = np.linalg.lstsq(columns, odds, rcond=None)[0]
    if np.abs(columns @ current - odds).max() > 0.01:
        sys.exit("fit.py: the odds in %s are no weighted sum of the features: log_odds() has other terms" % path)
    return columns, number("offset"), number("right"), np.array([row["set"] for row in rows]), current


def odds_of(features, offset, weights):
    return features @ weights + offset


def probability(odds):
    return 1 / (1 + np.exp(-np.clip(odds, -500, 500)))


def loss(odds, right):
    """Mean negative log-likelihood."""
    return np.mean(np.logaddexp(0, odds) - right * odds)


def fit(features, offset, right, current):
    """Newton's method from the current weights, with a ridge towards them on standardised features."""
    scale = features.std(0)
    scale[NAMES.index("one")] = 1
    weights = current.copy()
    for _ in range(50):
        p = probability(odds_of(features, offset, weights))
        gradient = features.T @ (right - p) - RIDGE * scale**2 * (weights - current)
        curvature = (features * (p * (1 - p))[:, None]).T @ features + np.diag(RIDGE * scale**2 + 1e-9)
        step = np.linalg.solve(curvature, gradient)
        weights += step * min(1, 5 / np.abs(step).max())
        if np.abs(step).max() < 1e-6:
            break
    return weights


def left_out(features, offset, right, sets, current):
    """Log-odds of each row by weights fitted to the rows of the other sets."""
    odds = np.empty(len(right))
    for one in np.unique(sets):
        own = sets == one
        odds[own] = odds_of(features[own], offset[own], fit(features[~own], offset[~own], right[~own], current))
    return odds


def counts(odds, right, limit=0.0):
    return "right %d, wrong %d" % (np.sum(right[odds > limit]), np.sum(1 - right[odds > limit]))


def reliability(odds, right):
    """(mean probability, fraction of correct ones, its deviation, rows) per range of probability."""
    p = probability(odds)
    bins = np.digitize(p, EDGES)
    table = []
    for k in range(len(EDGES) + 1):
        own = bins == k
        if np.any(own):
            share, count = right[own].mean(), np.sum(own)
            table.append((p[own].mean(), share, np.sqrt(share * (1 - share) / count), int(count)))
    return table


def plot(path, before, after):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    pyplot.style.use(str(pathlib.Path(__file__).parent.parent / "plot" / "legible.mplstyle"))
    figure, axes = pyplot.subplots(figsize=(5, 5))
    axes.plot([0, 1], [0, 1], color="grey", linewidth=1)
    for name, table in (("current weights", before), ("fitted, sets left out", after)):
        axes.errorbar([row[0] for row in table], [row[1] for row in table], [row[2] for row in table], marker="o",
                      label=name)
    axes.set_xlabel("predicted probability")
    axes.set_ylabel("share that is right")
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rows")
    parser.add_argument("--plot")
    arguments = parser.parse_args()
    features, offset, right, sets, current = read_rows(arguments.rows)
    before, after = odds_of(features, offset, current), left_out(features, offset, right, sets, current)
    print("%d rows of %d sets, %d right" % (len(right), len(np.unique(sets)), right.sum()))
    print("current weights: loss %.4f, above 0: %s" % (loss(before, right), counts(before, right)))
    print("sets left out:   loss %.4f, above 0: %s" % (loss(after, right), counts(after, right)))
    names = NAMES + ["small " + name for name in OF_SMALL]
    for name, old, new in zip(names, current, fit(features, offset, right, current)):
        print("%-18s %8.2f -> %8.2f" % (name, old, new))
    tables = reliability(before, right), reliability(after, right)
    for name, table in zip(("current", "left out"), tables):
        print("reliability, %s: %s" % (name, ", ".join("%.2f: %.2f +- %.2f (%d)" % row for row in table)))
    if arguments.plot:
        plot(arguments.plot, *tables)


if __name__ == "__main__":
    main()
