# SPDX-License-Identifier: BSD-3-Clause
"""Chessboards as a known camera sees them, published in place of a camera."""
import threading
import time

import cv2
import numpy

FOCAL_LENGTH = 600.0  # [px]
WIDTH, HEIGHT = 640, 480
MATRIX = numpy.array([[FOCAL_LENGTH, 0, WIDTH / 2], [0, FOCAL_LENGTH, HEIGHT / 2], [0, 0, 1]])
BOARD = (9, 6, 0.025)  # inner corners and squares [m], as the console proposes them
LAID_DOWN = (-0.1, -0.06, 0.6)  # [m] first inner corner of the board on the platform
PLACES = 12
SHOWN, RATE = 12, 10   # images per place and per second


def drawn_board(turn, place):
    columns, rows, square = BOARD
    image = numpy.full((HEIGHT, WIDTH), 200, numpy.uint8)
    for row in range(-1, rows):
        for column in range(-1, columns):
            if (row + column) % 2:
                corners = [((column + x) * square, (row + y) * square, 0.0)
                           for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
                pixels = cv2.projectPoints(numpy.array(corners), turn, place, MATRIX, None)[0]
                cv2.fillConvexPoly(image, numpy.round(pixels * 256).astype(numpy.int32), 20, cv2.LINE_AA, 8)
    return image


class Boards:
    def __init__(self):
        import rospy
        from sensor_msgs.msg import CameraInfo, Image
        self._images = rospy.Publisher("/image_raw", Image, queue_size=1)
        self._infos = rospy.Publisher("/camera_info", CameraInfo, queue_size=1)
        self._lying = threading.Event()

    def show_all(self):
        """Shows the board at one place after another, each rotated differently, as an operator moves it."""
        for i in range(PLACES):
            x, y = (i % 4 - 1.5) * 0.09, (i // 4 - 1) * 0.07
            self._show(drawn_board(numpy.array((0.3 * (i % 3 - 1), 0.3 * (i // 4 - 1), 0.05 * i)),
                                   numpy.array((x - 0.1, y - 0.06, 0.5 + 0.01 * i))))

    def lay_down(self):
        """Shows the board on the platform, with the camera's calibration, until take_up()."""
        board = drawn_board(numpy.zeros(3), numpy.array(LAID_DOWN))
        self._lying.set()
        threading.Thread(target=self._show_lying, args=(board,), daemon=True).start()

    def take_up(self):
        self._lying.clear()

    def _show_lying(self, image):
        from sensor_msgs.msg import CameraInfo
        info = CameraInfo(height=HEIGHT, width=WIDTH, distortion_model="plumb_bob", D=[0.0] * 5, K=MATRIX.ravel())
        while self._lying.is_set():
            info.header = self._publish(image)
            self._infos.publish(info)

    def _show(self, image):
        for _ in range(SHOWN):
            self._publish(image)

    def _publish(self, image):
        import rospy
        from sensor_msgs.msg import Image
        message = Image(height=HEIGHT, width=WIDTH, encoding="mono8", step=WIDTH, data=image.tobytes())
        message.header.frame_id, message.header.stamp = "camera_optical_frame", rospy.Time.now()
        self._images.publish(message)
        time.sleep(1 / RATE)
        return message.header
