#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes cases of photographs from fetched public repositories.

MIRROR/OWNER+NAME holds a git repository (bare, in `repo`, or with `.git`), e.g. of
`git clone --bare https://github.com/OWNER/NAME MIRROR/OWNER+NAME`. Every CASES_DIR/SOURCE.yaml
names one repository at one commit, its images and the true outlines:

  source, repository (OWNER/NAME), commit, licence, half (tune or report), truth (how made, how
  good), scale (factor the images are resized by; a case may have its own), new (a source not
  used before), and cases: name, before, after (paths), before_frame, after_frame (of videos,
  from 0), outline, holes (lists of polygons of the resized image), roi (x y width height),
  click (x y), crop (x y width height: the part of the resized image that is used, because more
  changed outside it), alike (objects that look the same share it), note

Written are
OUT/pairs/SOURCE/CASE/{learn_before.png,learn_after.png,gt_mask.png,roi.txt,click.txt} and
OUT/pairs/SOURCE/SOURCE.json. What is missing is reported in one sentence and skipped.
"""
import argparse
import functools
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import cv2
import numpy as np
import yaml


class Missing(Exception):
    """A repository, file or frame that does not exist."""


def git_dir(mirror, repository):
    folder = mirror / repository.replace("/", "+")
    for candidate in (folder / "repo" / ".git", folder / "repo", folder / ".git", folder):
        if (candidate / "HEAD").is_file():
            return candidate
    raise Missing("no git repository in {}".format(folder))


def frame_of(data, number, suffix):
    """One frame of a video; counted while decoding, since seeking is inexact in some files."""
    with tempfile.NamedTemporaryFile(suffix=suffix) as file:
        file.write(data)
        file.flush()
        video = cv2.VideoCapture(file.name)
        for _ in range(number):
            if not video.grab():
                raise Missing("the video has no frame {}".format(number))
        good, image = video.read()
        if not good:
            raise Missing("the video has no frame {}".format(number))
        return image


@functools.lru_cache(maxsize=8)
def image_of(git, commit, path, frame, scale):
    shown = subprocess.run(["git", "--git-dir", str(git), "show", "{}:{}".format(commit, path)],
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if shown.returncode:
        raise Missing("{} has no {} at {}".format(git, path, commit[:10]))
    if frame is None:
        image = cv2.imdecode(np.frombuffer(shown.stdout, np.uint8), cv2.IMREAD_COLOR)
    else:
        image = frame_of(shown.stdout, frame, Path(path).suffix)
    if image is None:
        raise Missing("{} at {} is not an image".format(path, commit[:10]))
    if scale != 1:
        size = (round(image.shape[1] * scale), round(image.shape[0] * scale))
        image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    return image


def filled(shape, polygon):
    mask = np.zeros(shape[:2], np.uint8)
    cv2.fillPoly(mask, [np.round(np.array(polygon)).astype(np.int32)], 255)
    return mask


def mask_of(shape, outline, holes):
    """Outlines and holes run along the object's outermost pixels, as in the result of cv2.findContours."""
    mask = np.zeros(shape[:2], np.uint8)
    for polygon in outline:
        mask |= filled(shape, polygon)
    empty = np.zeros_like(mask)
    for polygon in holes:
        hole = filled(shape, polygon)
        cv2.polylines(hole, [np.round(np.array(polygon)).astype(np.int32)], True, 0)
        empty |= hole
    mask[empty > 0] = 0
    return mask


def make_case(git, source, case, folder):
    scale = case.get("scale", source.get("scale", 1))

    def image(which):
        return image_of(git, source["commit"], case[which], case.get(which + "_frame"), scale)

    before, after = image("before"), image("after")
    if before.shape != after.shape:
        raise Missing("{} and {} differ in size".format(case["before"], case["after"]))
    left, top, width, height = case.get("crop", [0, 0, before.shape[1], before.shape[0]])
    part = slice(top, top + height), slice(left, left + width)
    folder.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(folder / "learn_before.png"), before[part])
    cv2.imwrite(str(folder / "learn_after.png"), after[part])
    cv2.imwrite(str(folder / "gt_mask.png"),
                mask_of(before.shape, case["outline"], case.get("holes", []))[part])
    x, y, w, h = case["roi"]
    (folder / "roi.txt").write_text("{} {} {} {}\n".format(x - left, y - top, w, h))
    (folder / "click.txt").write_text("{} {}\n".format(case["click"][0] - left, case["click"][1] - top))


def make_source(mirror, out, path):
    """Returns the number of cases made and the number of cases listed."""
    source = yaml.safe_load(path.read_text())
    folder = out / "pairs" / source["source"]
    made = 0
    try:
        git = git_dir(mirror, source["repository"])
    except Missing as problem:
        print("{}: {}.".format(source["source"], problem), file=sys.stderr)
        return 0, len(source["cases"])
    for case in source["cases"]:
        try:
            make_case(git, source, case, folder / case["name"])
            made += 1
        except Missing as problem:
            print("{}/{}: {}.".format(source["source"], case["name"], problem), file=sys.stderr)
    if made:
        (folder / "SOURCE.json").write_text(json.dumps({"half": source["half"]}) + "\n")
    return made, len(source["cases"])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mirror", type=Path, help="folder of fetched repositories")
    parser.add_argument("out", type=Path, help="folder to write the cases to")
    parser.add_argument("cases", type=Path, nargs="?", default=Path(__file__).parent / "cases",
                        help="folder of the YAML files (default: cases beside this script)")
    arguments = parser.parse_args()
    counts = []
    for path in sorted(arguments.cases.glob("*.yaml")):
        counts.append(make_source(arguments.mirror, arguments.out, path))
        print("{}: {} of {} cases".format(path.stem, *counts[-1]))
    made, named = (sum(column) for column in zip(*counts)) if counts else (0, 0)
    print("{} of {} cases in {}".format(made, named, arguments.out))
    return 0 if made == named and named else 1


if __name__ == "__main__":
    sys.exit(main())
