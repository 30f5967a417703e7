#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes search cases of photographs from fetched public repositories.

MIRROR is as in make_cases.py. Every CASES_DIR/SOURCE.yaml names one repository at one commit, the
objects taught in its photographs, and where they are in others:

  source, repository (OWNER/NAME), commit, licence, truth (how made, how good), object (its kind,
  becomes a tag; a case may have its own), tags (further ones), and cases: name, symmetry (period
  of the angle in degrees, 0: any angle, absent: none), outline, holes (lists of polygons of the
  resulting image), reference (x y of the object's point that the poses locate), and searches,
  each with instances (lists of x, y, degrees, then the hidden part if above 0 and tags), ignore
  (lists of x, y, radius: finds there count neither way), absent (true: certainly not there)

Cases (the image taught) and searches name an image (path) and, if needed, a frame (of a video,
from 0). The following are done in this order, each of the image itself or else of the source:

  crop (x y width height), scale (a factor, or a list of factors and sizes [width, height] in
  turn), warp (3 x 3 matrix from the image to the resulting one, row by row) to size (width
  height), part (x y width height, after the scaling), turn (degrees clockwise, multiples of 90)

Written are OUT/SOURCE/CASE/{learn_before.png,gt_mask.png,ref.txt,roi.txt,target_*.png,gt.csv,
ignore.csv,targets.csv,meta.json}; roi.txt is the box of the object made 20 % larger. What is
missing is reported in one sentence and skipped: a search, or a case without its taught image.
"""
import argparse
import json
import sys
from pathlib import Path

import cv2
import numpy as np
import yaml

from make_cases import Missing, git_dir, image_of, mask_of

TURNS = {90: cv2.ROTATE_90_CLOCKWISE, 180: cv2.ROTATE_180, 270: cv2.ROTATE_90_COUNTERCLOCKWISE}


def cut(image, box, path):
    x, y, width, height = box
    if x + width > image.shape[1] or y + height > image.shape[0]:
        raise Missing("{} is smaller than the part of it that is named".format(path))
    return image[y:y + height, x:x + width]


def resized(image, step):
    """Scales by a factor (exactly, although the size is rounded) or to a size."""
    if isinstance(step, list):
        return cv2.resize(image, tuple(step), interpolation=cv2.INTER_AREA)
    return cv2.resize(image, None, fx=step, fy=step,
                      interpolation=cv2.INTER_AREA if step < 1 else cv2.INTER_CUBIC)


def image_for(git, source, item):
    """The image of a case or search, processed as stated there or in the source."""
    def stated(name):
        return item.get(name, source.get(name))

    path = item["image"]
    image = image_of(git, source["commit"], path, item.get("frame"), 1)
    if stated("crop"):
        image = cut(image, stated("crop"), path)
    steps = stated("scale") or []
    for step in steps if isinstance(steps, list) else [steps]:
        image = resized(image, step)
    if stated("warp"):
        image = cv2.warpPerspective(image, np.array(stated("warp"), float).reshape(3, 3),
                                    tuple(stated("size")), flags=cv2.INTER_CUBIC,
                                    borderMode=cv2.BORDER_REPLICATE)
    if stated("part"):
        image = cut(image, stated("part"), path)
    if stated("turn"):
        image = cv2.rotate(image, TURNS[stated("turn")])
    return image


def roi_of(mask):
    x, y, width, height = cv2.boundingRect(mask)
    left, top = max(0, x - round(width / 10)), max(0, y - round(height / 10))
    right = min(mask.shape[1], x + width + round(width / 10))
    bottom = min(mask.shape[0], y + height + round(height / 10))
    return left, top, right - left, bottom - top


def row_of(target, number, instance, kind):
    """One line of gt.csv."""
    x, y, degrees, *more = instance
    hidden = more.pop(0) if more and not isinstance(more[0], str) else 0
    tags = ["real", kind, "partly" if hidden > 0.1 else "fully"] + more
    return "{},{},{:.2f},{:.2f},{:.2f},{:.2f},{}\n".format(target, number, x, y, degrees, hidden,
                                                           ";".join(tags))


def make_case(git, source, case, folder):
    """Returns the number of searches made."""
    learn = image_for(git, source, case)
    mask = mask_of(learn.shape, case["outline"], case.get("holes", []))
    folder.mkdir(parents=True, exist_ok=True)
    kind = case.get("object", source["object"])
    rows, ignored, targets = [], [], []
    for position, search in enumerate(case["searches"]):
        target = "target_{:03d}".format(position)
        try:
            image = image_for(git, source, search)
        except Missing as problem:
            print("{}/{}: {}.".format(source["source"], case["name"], problem), file=sys.stderr)
            continue
        cv2.imwrite(str(folder / (target + ".png")), image)
        for number, instance in enumerate(search.get("instances", [])):
            rows.append(row_of(target, number, instance, kind))
        for circle in search.get("ignore", []):
            ignored.append("{},{:.1f},{:.1f},{:.1f}\n".format(target, *circle))
        targets.append(target + (",real;absent\n" if search.get("absent") else ",real\n"))
    cv2.imwrite(str(folder / "learn_before.png"), learn)
    cv2.imwrite(str(folder / "gt_mask.png"), mask)
    (folder / "ref.txt").write_text("{:g} {:g}\n".format(*case["reference"]))
    (folder / "roi.txt").write_text("{} {} {} {}\n".format(*roi_of(mask)))
    (folder / "gt.csv").write_text("target,instance,x,y,theta_deg,occlusion,tags\n" + "".join(rows))
    (folder / "targets.csv").write_text("target,tags\n" + "".join(targets))
    if ignored:
        (folder / "ignore.csv").write_text("target,x,y,radius_px\n" + "".join(ignored))
    tags = ["real", kind] + source.get("tags", [])
    if "symmetry" in case:
        tags.append("sym:{:g}".format(case["symmetry"]))
    meta = {name: source[name] for name in ("repository", "commit", "licence", "truth")}
    (folder / "meta.json").write_text(json.dumps(dict(meta, tags=tags), indent=1) + "\n")
    return len(targets)


def make_source(mirror, out, path):
    """Returns the number of searches made and the number of searches listed."""
    source = yaml.safe_load(path.read_text())
    named = sum(len(case["searches"]) for case in source["cases"])
    made = 0
    try:
        git = git_dir(mirror, source["repository"])
        for case in source["cases"]:
            try:
                made += make_case(git, source, case, out / source["source"] / case["name"])
            except Missing as problem:
                print("{}/{}: {}.".format(source["source"], case["name"], problem), file=sys.stderr)
    except Missing as problem:
        print("{}: {}.".format(source["source"], problem), file=sys.stderr)
    return made, named


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mirror", type=Path, help="folder of fetched repositories")
    parser.add_argument("out", type=Path, help="folder to write the cases to")
    parser.add_argument("cases", type=Path, nargs="?",
                        default=Path(__file__).parent / "search_cases",
                        help="folder of the YAML files (default: search_cases beside this script)")
    arguments = parser.parse_args()
    counts = []
    for path in sorted(arguments.cases.glob("*.yaml")):
        counts.append(make_source(arguments.mirror, arguments.out, path))
        print("{}: {} of {} searches".format(path.stem, *counts[-1]))
    made, named = (sum(column) for column in zip(*counts)) if counts else (0, 0)
    print("{} of {} searches in {}".format(made, named, arguments.out))
    return 0 if made == named and named else 1


if __name__ == "__main__":
    sys.exit(main())
