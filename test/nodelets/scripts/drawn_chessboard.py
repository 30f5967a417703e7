# SPDX-License-Identifier: BSD-3-Clause
"""Draws a chessboard on a platform as a distorted camera sees it, and provides the camera's calibration."""
import cv2
import numpy as np
import yaml

MATRIX = np.array([[600.0, 0, 310], [0, 605, 245], [0, 0, 1]])
DISTORTION = np.array([-0.2, 0.05, 0.001, -0.001, 0])
COLUMNS, ROWS, SQUARE = 7, 5, 0.03
# The camera's z axis points down, the platform's up; the camera is slightly tilted.
TURN = cv2.Rodrigues(cv2.Rodrigues(np.array([np.pi, 0, 0]))[0] @ cv2.Rodrigues(np.array([0.12, -0.08, 0.3]))[0])[0]
PLACE = np.array([-0.10, -0.07, 0.62])


def project(points, turn=TURN, place=PLACE):
    return cv2.projectPoints(np.asarray(points, float), turn, place, MATRIX, DISTORTION)[0].reshape(-1, 2)


def chessboard(rows=ROWS, turn=TURN, place=PLACE):
    """Draws at three times the resolution, square by square with curved edges, then scales down."""
    fine = 3
    image = np.full((480 * fine, 640 * fine), 200, np.uint8)
    for row in range(-1, rows):
        for column in range(-1, COLUMNS):
            if (row + column) % 2:
                continue
            side = np.linspace(0, 1, 20)
            outline = ([(column + t, row) for t in side] + [(column + 1, row + t) for t in side] +
                       [(column + 1 - t, row + 1) for t in side] + [(column, row + 1 - t) for t in side])
            pixels = project([(SQUARE * x, -SQUARE * y, 0) for x, y in outline], turn, place)
            fixed = np.round(((pixels + 0.5) * fine - 0.5) * 256).astype(np.int32)
            cv2.fillPoly(image, [fixed], 30, cv2.LINE_AA, 8)
    reduced = cv2.resize(image, (640, 480), interpolation=cv2.INTER_AREA)
    noise = np.random.default_rng(1).normal(0, 2, reduced.shape)
    return np.clip(reduced + noise, 0, 255).astype(np.uint8)


def camera_yaml():
    """The calibration as a file for camera_info_manager."""
    projection = np.hstack([MATRIX, np.zeros((3, 1))])
    return yaml.safe_dump({
        "image_width": 640, "image_height": 480, "camera_name": "camera", "distortion_model": "plumb_bob",
        "camera_matrix": {"rows": 3, "cols": 3, "data": MATRIX.ravel().tolist()},
        "distortion_coefficients": {"rows": 1, "cols": 5, "data": DISTORTION.tolist()},
        "rectification_matrix": {"rows": 3, "cols": 3, "data": np.eye(3).ravel().tolist()},
        "projection_matrix": {"rows": 3, "cols": 4, "data": projection.ravel().tolist()}})
