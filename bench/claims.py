# SPDX-License-Identifier: BSD-3-Clause
"""Checks the paper's claims (doi 10.1177/1687814017728839) against the rows that the benchmark programs write.

Rows are dictionaries of text by column, as csv.DictReader reads them.
"""

VARIANTS = {"mbncc": "MB-NCC", "incircle": "PP-NCC incircle", "excircle": "PP-NCC excircle"}
SQUARE, IRREGULAR, ELONGATED = "1.0", "2.0", "4.0"  # elongations that paper_bench uses
ALIKE = 0.1        # scores that differ by less count as equal
SURE = 0.8         # score above which an object is found reliably
SLOWEST = 10_000   # [ms] that the paper allows for a lesson


class Claim:
    def __init__(self, figures, text, true, evidence):
        self.figures, self.text, self.true, self.evidence = figures, text, true, evidence

    def row(self):
        return "| %s | %s | **%s** | %s |" % (self.figures, self.text, "true" if self.true else "not true",
                                             self.evidence)


def learning_claims(figures):
    series = {(row["method"], int(row["iterations"])): row for row in figures}
    last = max(iterations for _, iterations in series)

    def accuracy(method, iterations=2):
        return float(series[method, iterations]["accuracy"])
    # The superpixels with the best result on these lessons.
    best = max((method for method, _ in series if method.startswith("sb_grabcut")), key=accuracy)
    own, settled = accuracy(best), accuracy(best, last)
    rivals = {name: accuracy(name, last) for name in ("grabcut_mask", "grabcut_rect")}
    slowest = max(float(row["lesson ms"]) for row in figures if row["lesson ms"] != "-")
    scribbles, change = accuracy("grabcut_scribbles"), accuracy("change_cut")
    said = ", ".join("%s %.3f" % pair for pair in rivals.items())
    return [
        Claim("9 to 11", "SB-GrabCut is more accurate than GrabCut from the mask and from a rectangle",
              own > max(rivals.values()), "%s %.3f after 2 cuts; %s after %d" % (best, own, said, last)),
        Claim("10", "It is settled within 2 iterations", abs(settled - own) < 0.02,
              "%.3f after 2 cuts, %.3f after %d" % (own, settled, last)),
        Claim("11", "It takes less than 10 s", slowest < SLOWEST,
              "slowest median lesson of all methods: %.0f ms" % slowest),
        Claim("9 to 11", "Scribbles are slightly better still", scribbles > own, "%.3f" % scribbles),
        Claim("ours", "The image after the grasp as evidence (change_cut) does better than all of them",
              change > max(own, scribbles, *rivals.values()), "%.3f" % change),
    ]


def background_claims(backgrounds):
    by_elongation = {e: [row for row in backgrounds if row["elongation"] == e]
                     for e in (SQUARE, IRREGULAR, ELONGATED)}
    lowest = {e: {name: min(float(row[name]) for row in rows) for name in VARIANTS}
              for e, rows in by_elongation.items()}

    def said(elongation):
        return "lowest of six: " + ", ".join("%s %.2f" % (VARIANTS[n], v)
                                              for n, v in lowest[elongation].items())
    square = lowest[SQUARE].values()
    rest = [lowest[e] for e in (IRREGULAR, ELONGATED)]
    return [
        Claim("12, 13", "On a compact object all variants are alike", max(square) - min(square) < ALIKE,
              said(SQUARE)),
        Claim("12, 13", "MB-NCC stays high on elongated and irregular ones, whatever the background",
              all(low["mbncc"] > SURE for low in rest), said(ELONGATED)),
        Claim("12, 13", "PP-NCC with the excircle is unreliable there", all(low["excircle"] < SURE for low in rest),
              "irregular %.2f, elongated %.2f" % tuple(low["excircle"] for low in rest)),
        Claim("12, 13", "PP-NCC with the incircle is unreliable there", all(low["incircle"] < SURE for low in rest),
              "irregular %.2f, elongated %.2f" % tuple(low["incircle"] for low in rest)),
    ]


def half_width(curve):
    """[degrees] at which the score has fallen half-way to its lowest."""
    half = (max(curve) + min(curve)) / 2
    return next(degrees for degrees, score in enumerate(curve) if score < half)


def rotation_claims(rotation):
    curves = {name: [float(row[name]) for row in rotation if row["elongation"] == ELONGATED] for name in VARIANTS}
    widths = {name: half_width(curve) for name, curve in curves.items()}
    at_180 = {name: max(curve[170:191]) for name, curve in curves.items()}
    between = {name: max(curve[60:121]) for name, curve in curves.items()}
    second = {name: at_180[name] > between[name] + ALIKE for name in VARIANTS}
    return [
        Claim("14, 15", "MB-NCC falls off more sharply around the true angle",
              widths["mbncc"] < min(widths["incircle"], widths["excircle"]),
              "half-way down at " + ", ".join("%s %d degrees" % (VARIANTS[n], w) for n, w in widths.items())),
        Claim("14, 15", "PP-NCC has a second peak at 180 degrees, MB-NCC has none",
              second["excircle"] and not second["mbncc"],
              "best within 10 degrees of 180: " + ", ".join("%s %.2f" % (VARIANTS[n], v) for n, v in at_180.items())),
    ]


def place_claims(table):
    scores = {row["variant"]: {key: float(row[key]) for key in ("object", "wastepaper", "elsewhere")}
              for row in table}

    def said(name):
        return "object %(object).2f, wastepaper %(wastepaper).2f, best elsewhere %(elsewhere).2f" % scores[name]
    mbncc, excircle = scores["mbncc"], scores["excircle"]
    return [
        Claim("14c, 16", "PP-NCC (excircle) scores the wastepaper above the object",
              excircle["wastepaper"] > excircle["object"], said("excircle")),
        Claim("14c, 16", "PP-NCC (incircle) scores the wastepaper above the object",
              scores["incircle"]["wastepaper"] > scores["incircle"]["object"], said("incircle")),
        Claim("14c, 16", "MB-NCC has a single peak at the object, so that a threshold is easy to set",
              mbncc["object"] - mbncc["elsewhere"] > 0.2, said("mbncc")),
    ]


def judged(learning, backgrounds, rotation, places):
    """All claims: rows of learning_bench's figures.csv, of paper_bench's backgrounds.csv, rotation.csv, wastepaper.csv."""
    return (learning_claims(learning) + background_claims(backgrounds) + rotation_claims(rotation) +
            place_claims(places))
