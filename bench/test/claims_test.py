#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the paper's claims against the tables of the stored page, and against the output of the built programs.

usage: claims_test.py [FOLDER_OF_THE_BENCHMARK_PROGRAMS]
"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(BENCH))

from claims import judged, learning_claims, place_claims  # noqa: E402  (found by the line above)

PAGE = (BENCH.parent / "docs/report/report.md").read_text(encoding="utf-8")
PROGRAMS = pathlib.Path(sys.argv.pop()) if len(sys.argv) > 1 else None


def rows_of_table(head):
    """The rows of the table in the page whose first column is named `head`."""
    lines = re.search(r"^\| %s .*\n(?:\|.*\n)+" % head, PAGE, re.MULTILINE).group(0).splitlines()
    names, _, *body = ([cell.strip() for cell in line.strip("|").split("|")] for line in lines)
    return [dict(zip(names, cells)) for cells in body]


def rows_of_file(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class KeptPage(unittest.TestCase):
    def test_its_tables_reproduce_its_claims(self):
        for claim in learning_claims(rows_of_table("method")) + place_claims(rows_of_table("variant")):
            self.assertIn(claim.row() + "\n", PAGE)


@unittest.skipUnless(PROGRAMS, "the benchmark programs are not built")
class Programs(unittest.TestCase):
    def test_write_the_figures_that_are_judged(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder)
            self.run_quietly("simulated_set", out / "set", "--cases=1")
            self.run_quietly("learning_bench", out / "set", "--out=%s" % out)
            self.run_quietly("paper_bench", out)
            claims = judged(*(rows_of_file(out / name) for name in
                              ("figures.csv", "backgrounds.csv", "rotation.csv", "wastepaper.csv")))
        self.assertEqual(len(claims), len(re.findall(r"\*\*(?:not )?true\*\*", PAGE)))

    @staticmethod
    def run_quietly(program, *arguments):
        subprocess.run([PROGRAMS / program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)


if __name__ == "__main__":
    unittest.main()
