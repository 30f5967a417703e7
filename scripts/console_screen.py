# SPDX-License-Identifier: BSD-3-Clause
"""Reads what Xvfb shows from the file of its frame buffer (-fbdir), in the format of xwd."""
import cv2
import numpy

from console_session import SessionFailed, wait_for

HEADER, COLOUR = 25, 12  # [words] of the header; [bytes] of an entry of the colour map
NOISE = 30               # [grey levels] of the live image
STEADY = 0.995           # of the pixels


def screen(folder):
    """The screen as BGR."""
    data = (folder / "Xvfb_screen0").read_bytes()
    words = numpy.frombuffer(data, ">u4", HEADER)
    width, height, step, colours = (int(words[i]) for i in (4, 5, 12, 19))
    pixels = numpy.frombuffer(data, numpy.uint8, height * step, int(words[0]) + colours * COLOUR)
    return pixels.reshape(height, step // 4, 4)[:, :width, :3].copy()


def settled_screen(folder, patience=5):
    """The screen once the window has drawn itself: two successive images are equal except for noise."""
    last = [screen(folder)]

    def settled():
        before, last[0] = last[0], screen(folder)
        return numpy.mean(cv2.absdiff(before, last[0]).max(axis=2) < NOISE) > STEADY

    try:
        wait_for(settled, "the window has drawn itself", patience)
    except SessionFailed:
        pass  # something moves in the live image
    return last[0]
