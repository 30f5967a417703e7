#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes trays: images in which each object of a set lies many times, in a grid and at random angles.

usage: trays.py SET OUT [--count N] [--grain G] [--seed N]
  SET      folder of cases (README.md)
  OUT      folder for the cases of the trays; files of the lesson are linked
  --count  instances per image; default: 36
  --grain  texture [grey levels] that replaces most of the background; default: 0, the background of the next case

Objects wider than a cell overlap, which their occlusion (always 0) does not tell. Needs python3-opencv.
"""
import argparse
import csv
import pathlib

import cv2
import numpy as np

SIZE = (1536, 1024)  # [px]
LESSON = ('learn_before.png', 'learn_after.png', 'gt_mask.png', 'ref.txt', 'roi.txt', 'meta.json')
COLUMNS = ['target', 'instance', 'x', 'y', 'theta_deg', 'occlusion', 'tags']


def background(case, grain, random):
    image = cv2.imread(str(case / 'learn_after.png'))
    mirrored = np.hstack([image, image[:, ::-1], image])
    ground = np.vstack([mirrored, mirrored[::-1], mirrored])[:SIZE[1], :SIZE[0]].astype(np.float32)
    if grain > 0:
        noise = random.normal(0, 1, (SIZE[1] // 2, SIZE[0] // 2, 3)).astype(np.float32)
        texture = cv2.resize(cv2.GaussianBlur(noise, (0, 0), 1.2), SIZE)
        ground = .3 * ground + 110 + grain * texture / texture.std()
    return ground


def grid(count):
    """Centres [px] of cells."""
    rows = round((count * SIZE[1] / SIZE[0]) ** .5)
    columns = -(-count // rows)
    for k in range(count):
        yield (k % columns + .5) * SIZE[0] / columns, (k // columns + .5) * SIZE[1] / rows


def tray(case, ground, count, random):
    """The image, and the pose of the reference point of each instance: x, y, degrees."""
    image = cv2.imread(str(case / 'learn_before.png')).astype(np.float32)
    mask = cv2.imread(str(case / 'gt_mask.png'), cv2.IMREAD_GRAYSCALE)
    reference = np.array([float(number) for number in (case / 'ref.txt').read_text().split()])
    centre = np.argwhere(mask > 127).mean(0)[::-1]
    poses = []
    for x, y in grid(count):
        degrees = random.uniform(-180, 180)
        matrix = cv2.getRotationMatrix2D(tuple(centre), -degrees, 1)
        matrix[:, 2] += np.array([x, y]) + random.uniform(-8, 8, 2) - centre
        cover = cv2.warpAffine(mask, matrix, SIZE).astype(np.float32) / 255
        cover = cv2.GaussianBlur(cover, (0, 0), .6)[..., None]
        ground = ground * (1 - cover) + cover * cv2.warpAffine(image, matrix, SIZE, flags=cv2.INTER_CUBIC)
        poses.append((*(matrix[:, :2] @ reference + matrix[:, 2]), degrees))
    return ground, poses


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('set', type=pathlib.Path)
    parser.add_argument('out', type=pathlib.Path)
    parser.add_argument('--count', type=int, default=36)
    parser.add_argument('--grain', type=float, default=0)
    parser.add_argument('--seed', type=int, default=1)
    options = parser.parse_args()
    cases = sorted(path.parent for path in options.set.glob('*/ref.txt'))
    if not cases:
        parser.error('%s contains no cases' % options.set)
    for number, case in enumerate(cases):
        random = np.random.default_rng([options.seed, number])
        ground = background(cases[(number + 1) % len(cases)], options.grain, random)
        image, poses = tray(case, ground, options.count, random)
        image += random.normal(0, 2, image.shape)
        out = options.out / case.name
        out.mkdir(parents=True)
        for name in LESSON:
            if (case / name).exists():
                (out / name).symlink_to((case / name).resolve())
        cv2.imwrite(str(out / 'target_000.png'), np.clip(np.rint(image), 0, 255).astype(np.uint8))
        with open(case / 'gt.csv') as file:
            tags = next((row['tags'] for row in csv.DictReader(file)), '')
        with open(out / 'gt.csv', 'w', newline='') as file:
            writer = csv.writer(file)
            writer.writerow(COLUMNS)
            for k, (x, y, degrees) in enumerate(poses):
                writer.writerow(['target_000', k, '%.4f' % x, '%.4f' % y, '%.4f' % degrees, '0.0000', tags])


if __name__ == '__main__':
    main()
