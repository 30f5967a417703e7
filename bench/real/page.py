#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a page of all lessons of a real_lessons_bench run, worst first: images, map, truth, verdict.

usage: page.py RUN SET[,SET...] OUT [--worst N]
  RUN    folder given to real_lessons_bench as --out
  SET    folders that were taught
  OUT    folder for index.html and its images

Green is the true outline, red the learned one. Needs python3-opencv.
"""
import argparse
import csv
import html
import pathlib

import cv2
import numpy as np

MARGIN = 0.4  # margin around the object, as a fraction of its longer side
HEIGHT = 220  # [px] height of an image on the page


def case_folders(sets):
    return {(path.parent.parent.name, path.parent.name): path.parent
            for root in sets for path in pathlib.Path(root).rglob('learn_before.png')}


def outlined(image, masks_and_colours):
    for mask, colour in masks_and_colours:
        large = cv2.resize(mask, (image.shape[1], image.shape[0]), interpolation=cv2.INTER_NEAREST)
        contours, _ = cv2.findContours(large, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
        cv2.drawContours(image, contours, -1, colour, 1)
    return image


def strip(folder, learned):
    before = cv2.imread(str(folder / 'learn_before.png'))
    after = cv2.imread(str(folder / 'learn_after.png'))
    truth = (cv2.imread(str(folder / 'gt_mask.png'), 0) > 127).astype(np.uint8)
    learned = (learned > 127).astype(np.uint8)
    x, y, w, h = cv2.boundingRect(truth | learned)
    margin = int(MARGIN * max(w, h)) + 4
    rows = slice(max(0, y - margin), y + h + margin)
    columns = slice(max(0, x - margin), x + w + margin)
    scale = HEIGHT / before[rows, columns].shape[0]
    size = (max(1, round(before[rows, columns].shape[1] * scale)), HEIGHT)

    def enlarged(image):
        return cv2.resize(image[rows, columns], size, interpolation=cv2.INTER_CUBIC if scale > 1 else cv2.INTER_AREA)

    shown = outlined(enlarged(before), [(truth[rows, columns], (0, 220, 0)), (learned[rows, columns], (0, 0, 255))])
    parts = [enlarged(before), shown] + ([enlarged(after)] if after is not None else [])
    return np.hstack(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('run', type=pathlib.Path)
    parser.add_argument('sets')
    parser.add_argument('out', type=pathlib.Path)
    parser.add_argument('--worst', type=int, default=0, help='only the worst N; 0: all')
    arguments = parser.parse_args()
    folders = case_folders(arguments.sets.split(','))
    with open(arguments.run / 'cases.csv') as file:
        rows = sorted(csv.DictReader(file), key=lambda row: float(row['iou']))
    arguments.out.mkdir(parents=True, exist_ok=True)
    entries = []
    for row in rows[:arguments.worst or None]:
        name = f"{row['source']}__{row['case']}.png"
        learned = cv2.imread(str(arguments.run / name), 0)
        cv2.imwrite(str(arguments.out / name), strip(folders[row['source'], row['case']], learned))
        title = (f"{row['source']} {row['case']}: IoU {float(row['iou']):.3f}, boundary F {float(row['boundary_f']):.3f}, "
                 f"{row['verdict']} {row['reasons']}")
        entries.append(f'<p>{html.escape(title)}<br><img src="{html.escape(name)}"></p>')
    page = '<!doctype html><meta charset="utf-8"><title>Real lessons</title>' + '\n'.join(entries)
    (arguments.out / 'index.html').write_text(page)
    print(arguments.out / 'index.html')


if __name__ == '__main__':
    main()
