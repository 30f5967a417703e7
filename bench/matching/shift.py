#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shifts the targets of a simulated set, including the truth, to typical real conditions.

usage: shift.py SET OUT KIND [--seed N]
  SET   folder of cases (README.md)
  OUT   folder for the shifted cases; files that a kind does not change are linked
  KIND  colour11, colour12       gains of red x1.1 and blue x.9; x1.2 and x.8
        gain18                   gain of 1.8, clipped
        dim                      gain of .4, and noise of 1.5 grey levels
        shadow_across            the edge of a shadow (.55) across the image, 30 to 80 px from an object
        shadow_on                ... through the centre of an object
        gloss                    a white spot on 15 % of each object
        covered                  a hand on 20 to 30 % of each object
        defocus2, defocus3       blur by a disc with this radius in pixels
        grey_target, grey_lesson grey targets; grey lesson images
        scale90, 95, 105, 110    targets resized
        tilt6, tilt10            the platform tilted by this many degrees (focal length: 1.3 widths)
        jpeg20                   compression with subsampled chroma
        bayer                    mosaic and bilinear demosaicing
        motion6                  blur along 6 px
        ordinary_day             tilt 2, scale .98, red x1.07, blue x.93, shadow .7, vignetting .2, bayer, JPEG 85

Needs python3-opencv.
"""
import argparse
import csv
import pathlib

import cv2
import numpy as np

LESSON = ('learn_before.png', 'learn_after.png')


class Target:
    """An image, the 3 x 3 matrix of its warp, and the objects in it."""

    def __init__(self, image, rows, shape, random):
        self.image = image.astype(np.float32)
        self.rows = rows
        self.motion = np.eye(3)
        self.shape = shape  # true map, reference point
        self.random = random

    def warp(self, matrix):
        height, width = self.image.shape[:2]
        self.image = cv2.warpPerspective(self.image, matrix, (width, height), flags=cv2.INTER_CUBIC,
                                         borderMode=cv2.BORDER_REFLECT_101)
        self.motion = matrix @ self.motion

    def pose(self, row):
        """x, y, theta of an object after all warps: position of its reference, rotation of the nearest similarity."""
        at = np.array([float(row['x']), float(row['y']), 1.])
        mapped = self.motion @ at
        u, v, w = mapped
        derivative = (self.motion[:2, :2] - np.outer([u / w, v / w], self.motion[2, :2])) / w
        turn = np.arctan2(derivative[1, 0] - derivative[0, 1], derivative[0, 0] + derivative[1, 1])
        return u / w, v / w, np.radians(float(row['theta_deg'])) + turn

    def mask(self, row):
        """The object's true map in the shifted image."""
        mask, reference = self.shape
        angle = np.radians(float(row['theta_deg']))
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        shift = np.array([float(row['x']), float(row['y'])]) - turn @ reference
        matrix = self.motion @ np.vstack([np.hstack([turn, shift[:, None]]), [0, 0, 1]])
        return cv2.warpPerspective(mask, matrix, self.image.shape[1::-1]) > 127


def clipped(values):
    return np.clip(np.rint(values), 0, 255).astype(np.uint8)


def gain(*factors):
    def change(target):
        target.image = np.clip(target.image * np.array(factors, np.float32), 0, 255)
    return change


def dim(target):
    target.image = target.image * .4 + target.random.normal(0, 1.5, target.image.shape).astype(np.float32)


def edge_at(target, distance, depth):
    """A shadow on one side of a straight edge near an object, or near the centre if there is no object."""
    height, width = target.image.shape[:2]
    at = np.array([width / 2, height / 2])
    if target.rows:
        at = np.array(target.pose(target.rows[target.random.integers(len(target.rows))])[:2])
    angle = target.random.uniform(0, 2 * np.pi)
    rows, columns = np.mgrid[0:height, 0:width]
    depth_in = (columns - at[0]) * np.cos(angle) + (rows - at[1]) * np.sin(angle) - distance
    soft = target.random.uniform(.7, 4)
    target.image *= (1 - depth / (1 + np.exp(np.clip(-depth_in / soft, -50, 50))))[..., None].astype(np.float32)


def shadow_across(target):
    edge_at(target, target.random.uniform(30, 80), .45)


def shadow_on(target):
    edge_at(target, 0, .45)


def painted(target, part, colour):
    """Covers the given fraction of each object's pixels, from one side or as a spot, with an edge softened by 1 px."""
    cover = np.zeros(target.image.shape[:2], np.float32)
    for row in target.rows:
        cover = np.maximum(cover, part(target, row))
    cover = cv2.GaussianBlur(cover, (0, 0), 1)[..., None]
    target.image = target.image * (1 - cover) + cover * colour


def gloss(target):
    def spot(target, row):
        mask = target.mask(row)
        ys, xs = np.nonzero(mask)
        if not len(xs):
            return np.zeros(mask.shape, np.float32)
        pick = target.random.integers(len(xs))
        angle = target.random.uniform(0, np.pi)
        dx, dy = xs - xs[pick], ys - ys[pick]
        along, across = dx * np.cos(angle) + dy * np.sin(angle), 2 * (dy * np.cos(angle) - dx * np.sin(angle))
        distance = np.hypot(along, across)
        result = np.zeros(mask.shape, np.float32)
        inside = distance <= np.quantile(distance, .15)
        result[ys[inside], xs[inside]] = 1
        return result
    painted(target, spot, 250)


def covered(target):
    def hand(target, row):
        mask = target.mask(row)
        ys, xs = np.nonzero(mask)
        result = np.zeros(mask.shape, np.float32)
        if not len(xs):
            return result
        part = target.random.uniform(.2, .3)
        angle = target.random.uniform(0, 2 * np.pi)
        along = xs * np.cos(angle) + ys * np.sin(angle)
        limit = np.quantile(along, 1 - part)
        rows, columns = np.mgrid[0:mask.shape[0], 0:mask.shape[1]]
        depth = columns * np.cos(angle) + rows * np.sin(angle) - limit
        side = np.abs(rows * np.cos(angle) - columns * np.sin(angle) - (ys * np.cos(angle) - xs * np.sin(angle)).mean())
        half = .6 * max(np.ptp(ys * np.cos(angle) - xs * np.sin(angle)), 12)
        wave = 2 * np.sin(side / 7)
        result[(depth > wave) & (side < half) & (depth < 2.5 * half)] = 1
        row['occlusion'] = f'{part:.4f}'
        return result
    painted(target, hand, np.array([120, 150, 205], np.float32) * target.random.uniform(.7, 1.1))


def disc(radius):
    def blur(target):
        size = int(np.ceil(radius)) + 1
        fine = np.mgrid[-size * 8 - 4:size * 8 + 4, -size * 8 - 4:size * 8 + 4] / 8 + 1 / 16
        inside = (np.hypot(*fine) <= radius).astype(np.float64)
        kernel = inside.reshape(2 * size + 1, 8, 2 * size + 1, 8).sum((1, 3))
        target.image = cv2.filter2D(target.image, -1, kernel / kernel.sum(), borderType=cv2.BORDER_REFLECT_101)
    return blur


def motion(target):
    angle = target.random.uniform(0, np.pi)
    kernel = np.zeros((15, 15), np.float32)
    for step in np.linspace(-3, 3, 61):
        x, y = 7 + step * np.cos(angle), 7 + step * np.sin(angle)
        column, row = int(np.floor(x)), int(np.floor(y))
        for i in (0, 1):
            for j in (0, 1):
                kernel[row + j, column + i] += (1 - abs(x - column - i)) * (1 - abs(y - row - j))
    target.image = cv2.filter2D(target.image, -1, kernel / kernel.sum(), borderType=cv2.BORDER_REFLECT_101)


def grey(target):
    target.image = cv2.cvtColor(target.image, cv2.COLOR_BGR2GRAY)


def centred(width, height):
    return np.array([[1, 0, -(width - 1) / 2], [0, 1, -(height - 1) / 2], [0, 0, 1.]])


def scale(factor):
    def resize(target):
        height, width = target.image.shape[:2]
        if factor < 1:
            target.image = cv2.GaussianBlur(target.image, (0, 0), .5 * np.sqrt(1 / factor**2 - 1))
        to_centre = centred(width, height)
        target.warp(np.linalg.inv(to_centre) @ np.diag([factor, factor, 1]) @ to_centre)
    return resize


def tilt(degrees):
    def view(target):
        height, width = target.image.shape[:2]
        direction = target.random.uniform(0, 2 * np.pi)
        rotation = cv2.Rodrigues(np.radians(degrees) * np.array([np.cos(direction), np.sin(direction), 0.]))[0]
        camera = np.diag([1.3 * width, 1.3 * width, 1])
        plane = rotation.copy()
        plane[:, 2] = [0, 0, 1]  # points (x, y, 0) of the platform, one distance away
        to_centre = centred(width, height)
        matrix = camera @ plane @ np.linalg.inv(camera)
        target.warp(np.linalg.inv(to_centre) @ matrix @ to_centre)
    return view


def jpeg(quality):
    def compress(target):
        options = [cv2.IMWRITE_JPEG_QUALITY, quality]
        target.image = cv2.imdecode(cv2.imencode('.jpg', clipped(target.image), options)[1],
                                    cv2.IMREAD_COLOR).astype(np.float32)
    return compress


def bayer(target):
    image = clipped(target.image)
    mosaic = np.empty(image.shape[:2], np.uint8)
    mosaic[0::2, 0::2] = image[0::2, 0::2, 2]
    mosaic[0::2, 1::2] = image[0::2, 1::2, 1]
    mosaic[1::2, 0::2] = image[1::2, 0::2, 1]
    mosaic[1::2, 1::2] = image[1::2, 1::2, 0]
    target.image = cv2.cvtColor(mosaic, cv2.COLOR_BayerBG2BGR).astype(np.float32)


def vignetting(depth):
    def darken(target):
        height, width = target.image.shape[:2]
        rows, columns = np.mgrid[0:height, 0:width]
        distance = np.hypot(rows - height / 2, columns - width / 2) / np.hypot(height / 2, width / 2)
        target.image *= (1 - depth * distance**2)[..., None].astype(np.float32)
    return darken


def ordinary_day(target):
    tilt(2)(target)
    scale(.98)(target)
    gain(.93, 1, 1.07)(target)
    edge_at(target, target.random.uniform(-40, 80), .3)
    vignetting(.2)(target)
    bayer(target)
    jpeg(85)(target)


KINDS = {'none': lambda target: None,
         'colour11': gain(.9, 1, 1.1), 'colour12': gain(.8, 1, 1.2), 'gain18': gain(1.8, 1.8, 1.8), 'dim': dim,
         'shadow_across': shadow_across, 'shadow_on': shadow_on, 'gloss': gloss, 'covered': covered,
         'defocus2': disc(2), 'defocus3': disc(3), 'grey_target': grey, 'grey_lesson': lambda target: None,
         'scale90': scale(.9), 'scale95': scale(.95), 'scale105': scale(1.05), 'scale110': scale(1.1),
         'tilt6': tilt(6), 'tilt10': tilt(10), 'jpeg20': jpeg(20), 'bayer': bayer, 'motion6': motion,
         'ordinary_day': ordinary_day}


def shift_case(case, out, kind, random):
    out.mkdir(parents=True, exist_ok=True)
    mask = cv2.imread(str(case / 'gt_mask.png'), cv2.IMREAD_GRAYSCALE)
    ys, xs = np.nonzero(mask)
    reference = np.array([xs.mean(), ys.mean()])
    if (case / 'ref.txt').exists():
        reference = np.array([float(word) for word in (case / 'ref.txt').read_text().split()])
    with open(case / 'gt.csv', newline='') as file:
        reader = csv.DictReader(file)
        fields, truth = reader.fieldnames, list(reader)
    for path in sorted(case.glob('target_*.png')):
        rows = [row for row in truth if row['target'] == path.stem]
        target = Target(cv2.imread(str(path)), rows, (mask, reference), random)
        KINDS[kind](target)
        cv2.imwrite(str(out / path.name), clipped(target.image))
        for row in rows:
            x, y, angle = target.pose(row)
            angle = (np.degrees(angle) + 180) % 360 - 180
            row.update(x=f'{x:.4f}', y=f'{y:.4f}', theta_deg=f'{angle:.4f}')
    with open(out / 'gt.csv', 'w', newline='') as file:
        writer = csv.DictWriter(file, fields, lineterminator='\n')
        writer.writeheader()
        writer.writerows(truth)
    for name in LESSON:
        if kind == 'grey_lesson':
            cv2.imwrite(str(out / name), cv2.imread(str(case / name), cv2.IMREAD_GRAYSCALE))
    for path in case.iterdir():
        if not (out / path.name).exists():
            (out / path.name).symlink_to(path.resolve())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('set', type=pathlib.Path)
    parser.add_argument('out', type=pathlib.Path)
    parser.add_argument('kind', choices=KINDS)
    parser.add_argument('--seed', type=int, default=0)
    arguments = parser.parse_args()
    cases = sorted(path.parent for path in arguments.set.glob('*/gt.csv'))
    for number, case in enumerate(cases):
        random = np.random.default_rng([arguments.seed, number])
        shift_case(case, arguments.out / case.name, arguments.kind, random)


if __name__ == '__main__':
    main()
