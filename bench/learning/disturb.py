#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Adds disturbances of cameras and tables to lessons.

usage: disturb.py SET OUT KIND [--seed N]
  SET   folder that holds cases (learn_before.png, learn_after.png, gt_mask.png, roi.txt) at any depth
  OUT   folder for the disturbed cases
  KIND  moving_shadow   a stripe of shadow at a different place in each image
        glow            the platform around the object takes on its colour
        jpeg60, jpeg30  compression with subsampled chroma
        bayer           mosaic and bilinear demosaicing
        banding         flicker bands of +-3 grey levels, with a different phase in each image
        sharpened       unsharp mask, amount 1
        exposure        gain of 1.08 and white balance of +-4 % between the images
        noise           of 12 grey levels in each channel of both images
        faulty_pixels   .2 % black and white pixels in both images
        denoised        median of 5 x 5 pixels in both images
        defocused       the image after is blurred by 1.3 px
        gamma           of .85 in the image after
        haze            a fifth of the image after is grey
        turned          the camera turned by .3 degrees between the images

Needs python3-opencv.
"""
import argparse
import pathlib
import shutil

import cv2
import numpy as np


def to_image(values):
    return np.clip(np.rint(values), 0, 255).astype(np.uint8)


def shadow_mask(shape, roi, random):
    """1 in the light, .6 in a stripe through or near the region; its width is a part of the region's."""
    height, width = shape
    x, y, w, h = roi
    angle = random.uniform(0, 2 * np.pi)
    through = (x + random.uniform(-.5, 1.5) * w, y + random.uniform(-.5, 1.5) * h)
    rows, columns = np.mgrid[0:height, 0:width]
    distance = (columns - through[0]) * np.cos(angle) + (rows - through[1]) * np.sin(angle)
    depth = (np.abs(distance) - random.uniform(.15, .5) * max(w, h)) / random.uniform(.7, 3)
    return 1 - .4 / (1 + np.exp(np.clip(depth, -50, 50)))


def moving_shadow(before, after, mask, roi, random):
    return [to_image(image * shadow_mask(mask.shape, roi, random)[..., None]) for image in (before, after)]


def glow(before, after, mask, roi, random):
    """Adds up to a quarter of the object's mean colour; it falls off within about 20 px of the outline."""
    colour = before[mask > 0].mean(0)
    distance = cv2.distanceTransform((mask == 0).astype(np.uint8), cv2.DIST_L2, 5)
    part = random.uniform(.1, .25) * np.exp(-distance / random.uniform(8, 25)) * (mask == 0)
    part = cv2.GaussianBlur(part, (0, 0), .8)[..., None]
    return [to_image(before + part * (colour - .3 * before)), after]


def jpeg(quality):
    def compress(before, after, mask, roi, random):
        options = [cv2.IMWRITE_JPEG_QUALITY, quality]
        return [cv2.imdecode(cv2.imencode('.jpg', image, options)[1], cv2.IMREAD_COLOR) for image in (before, after)]
    return compress


def bayer(before, after, mask, roi, random):
    result = []
    for image in (before, after):
        mosaic = np.empty(mask.shape, np.uint8)
        mosaic[0::2, 0::2] = image[0::2, 0::2, 2]
        mosaic[0::2, 1::2] = image[0::2, 1::2, 1]
        mosaic[1::2, 0::2] = image[1::2, 0::2, 1]
        mosaic[1::2, 1::2] = image[1::2, 1::2, 0]
        result.append(cv2.cvtColor(mosaic, cv2.COLOR_BayerBG2BGR))
    return result


def banding(before, after, mask, roi, random):
    rows = np.arange(mask.shape[0])
    period = random.uniform(60, 160)
    return [to_image(image + 3 * np.sin(2 * np.pi * (rows / period + random.uniform()))[:, None, None])
            for image in (before, after)]


def sharpened(before, after, mask, roi, random):
    return [to_image(2. * image - cv2.GaussianBlur(image, (0, 0), 1.2)) for image in (before, after)]


def exposure(before, after, mask, roi, random):
    balance = random.uniform(.96, 1.04, 3)
    return [before, to_image(after * 1.08 * balance)]


def noise(before, after, mask, roi, random):
    return [to_image(image + random.normal(0, 12, image.shape)) for image in (before, after)]


def faulty_pixels(before, after, mask, roi, random):
    result = []
    for image in (before, after):
        image = image.copy()
        faulty = random.uniform(size=mask.shape) < .002
        image[faulty] = random.choice([0, 255], (faulty.sum(), 1))
        result.append(image)
    return result


def denoised(before, after, mask, roi, random):
    return [cv2.medianBlur(image, 5) for image in (before, after)]


def defocused(before, after, mask, roi, random):
    return [before, cv2.GaussianBlur(after, (0, 0), 1.3)]


def gamma(before, after, mask, roi, random):
    return [before, to_image(255 * (after / 255) ** .85)]


def haze(before, after, mask, roi, random):
    return [before, to_image(.8 * after + .2 * 210)]


def turned(before, after, mask, roi, random):
    height, width = mask.shape
    motion = cv2.getRotationMatrix2D((width / 2, height / 2), .3, 1)
    return [before, cv2.warpAffine(after, motion, (width, height), flags=cv2.INTER_CUBIC,
                                   borderMode=cv2.BORDER_REPLICATE)]


KINDS = {'moving_shadow': moving_shadow, 'glow': glow, 'jpeg60': jpeg(60), 'jpeg30': jpeg(30), 'bayer': bayer,
         'banding': banding, 'sharpened': sharpened, 'exposure': exposure, 'noise': noise, 'faulty_pixels': faulty_pixels,
         'denoised': denoised, 'defocused': defocused, 'gamma': gamma, 'haze': haze, 'turned': turned}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('set', type=pathlib.Path)
    parser.add_argument('out', type=pathlib.Path)
    parser.add_argument('kind', choices=KINDS)
    parser.add_argument('--seed', type=int, default=0)
    arguments = parser.parse_args()
    for number, case in enumerate(sorted(path.parent for path in arguments.set.rglob('learn_after.png'))):
        random = np.random.default_rng([arguments.seed, number])
        before, after = (cv2.imread(str(case / f'learn_{when}.png')) for when in ('before', 'after'))
        mask = cv2.imread(str(case / 'gt_mask.png'), cv2.IMREAD_GRAYSCALE)
        roi = [float(word) for word in (case / 'roi.txt').read_text().split()]
        images = KINDS[arguments.kind](before, after, mask, roi, random)
        out = arguments.out / case.relative_to(arguments.set)
        out.mkdir(parents=True, exist_ok=True)
        for when, image in zip(('before', 'after'), images):
            cv2.imwrite(str(out / f'learn_{when}.png'), image)
        for name in ('gt_mask.png', 'roi.txt', 'click.txt', 'meta.json'):
            if (case / name).exists():
                shutil.copy(case / name, out / name)
        for source in case.parent.glob('*.json'):
            shutil.copy(source, out.parent / source.name)


if __name__ == '__main__':
    main()
