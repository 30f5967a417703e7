#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""calibrate_platform finds the pose of a drawn chessboard and of measured points.

usage: calibrate_platform_test.py PATH/TO/calibrate_platform
"""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
from importlib.machinery import SourceFileLoader

import cv2
import numpy as np
import rospy
import yaml
from cv_bridge import CvBridge

from drawn_chessboard import COLUMNS, MATRIX, PLACE, ROWS, SQUARE, TURN, camera_yaml, chessboard, project

SCRIPT = sys.argv.pop(1)
loader = SourceFileLoader("calibrate_platform", SCRIPT)
calibrate_platform = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
sys.dont_write_bytecode = True
loader.exec_module(calibrate_platform)


class CalibratePlatformTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("camera.yaml", camera_yaml())

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def call(self, *arguments):
        return subprocess.run(["/usr/bin/python3", SCRIPT, "--out", self.path("out"), "--camera-info",
                               self.path("camera.yaml"), *arguments], capture_output=True, text=True, check=False)

    def transform(self):
        with open(self.path("out/platform.launch"), encoding="utf-8") as file:
            arguments = re.search('args="([^"]*)"', file.read()).group(1).split()
        numbers = np.array([float(text) for text in arguments[:7]])
        angle = 2 * np.arccos(np.clip(numbers[6], -1, 1))
        turn = numbers[3:6] / max(np.sin(angle / 2), 1e-9) * angle
        return numbers[:3], cv2.Rodrigues(turn)[0], arguments[7:]

    def expect_true_pose(self, place_within, turn_within, true_turn=TURN, true_place=PLACE):
        place, rotation, frames = self.transform()
        self.assertEqual(frames, ["camera_optical_frame", "platform"])
        self.assertLess(np.linalg.norm(place - true_place), place_within)
        off = cv2.Rodrigues(rotation.T @ cv2.Rodrigues(true_turn)[0])[0]
        self.assertLess(np.degrees(np.linalg.norm(off)), turn_within)

    def test_chessboard(self):
        cv2.imwrite(self.path("board.png"), chessboard())
        done = self.call("--chessboard", "%dx%d" % (COLUMNS, ROWS), "--square", str(SQUARE), "--image",
                         self.path("board.png"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_true_pose(0.001, 0.3)
        with open(self.path("out/platform.yaml"), encoding="utf-8") as file:
            self.assertEqual(yaml.safe_load(file), {
                "platform_frame": "platform", "platform_intrinsics":
                "plumb_bob 640 480 600.0 605.0 310.0 245.0 -0.2 0.05 0.001 -0.001 0.0"})
        self.assertIn("looks the same after half a turn", done.stdout)
        self.assertRegex(done.stdout, r"height uncertain by up to 0\.\d\d mm at the image's edge")

    def test_the_origin_is_the_same_corner_for_any_board_pose(self):
        rows = 4
        centre = np.array([(COLUMNS - 1) / 2, -(rows - 1) / 2, 0]) * SQUARE
        for degrees in range(0, 360, 30):
            about_z = cv2.Rodrigues(np.array([0, 0, np.radians(degrees)]))[0]
            rotation = cv2.Rodrigues(TURN)[0] @ about_z
            place, turn = np.array([0.01, 0, 0.62]) - rotation @ centre, cv2.Rodrigues(rotation)[0]
            cv2.imwrite(self.path("board.png"), chessboard(rows, turn, place))
            done = self.call("--chessboard", "%dx%d" % (COLUMNS, rows), "--square", str(SQUARE), "--image",
                             self.path("board.png"))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("half a turn", done.stdout)
            self.expect_true_pose(0.001, 0.5, turn, place)

    def test_states_the_uncertainty_of_the_height(self):
        points = calibrate_platform.board_points(COLUMNS, ROWS, SQUARE, 0)
        camera = calibrate_platform.Camera(yaml.safe_load(camera_yaml()), False)
        exact = project(points)
        random = np.random.default_rng(5)
        width, height = camera.size
        rays = np.array([((x - MATRIX[0, 2]) / MATRIX[0, 0], (y - MATRIX[1, 2]) / MATRIX[1, 1], 1)
                         for x in (0, width - 1) for y in (0, height - 1)])
        normal = cv2.Rodrigues(TURN)[0][:, 2]
        corners = rays * (normal @ PLACE / (rays @ normal))[:, None]
        errors, stated = [], []
        for _ in range(100):
            rotation, place, _, error = calibrate_platform.solve(points, exact + random.normal(0, 0.1, exact.shape), camera)
            errors.append((corners - place) @ rotation[:, 2])
            stated.append(error)
        ratio = np.sqrt(np.mean(np.square(errors), axis=0)).max() / np.mean(stated)
        self.assertGreater(ratio, 0.7)
        self.assertLess(ratio, 1.4)

    def test_measured_points(self):
        points = [(0, 0, 0), (0.2, 0, 0), (0.2, -0.15, 0), (0, -0.15, 0), (0.1, -0.07, 0.02)]
        lines = ["%f,%f,%f,%f,%f" % (*pixel, *point) for pixel, point in zip(project(points), points)]
        self.write("points.csv", "# u,v,x,y,z\n" + "\n".join(lines))
        done = self.call("--points", self.path("points.csv"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_true_pose(1e-4, 0.01)

    def test_measured_points_under_a_fisheye(self):
        distortion = np.array([0.05, -0.02, 0.01, -0.004])
        points = np.array([(0, 0, 0), (0.2, 0, 0), (0.2, -0.15, 0), (0, -0.15, 0), (0.1, -0.07, 0.02)])
        turn = cv2.Rodrigues(cv2.Rodrigues(TURN)[0])[0]
        pixels = cv2.fisheye.projectPoints(points.reshape(-1, 1, 3), turn, PLACE.reshape(3, 1), MATRIX,
                                           distortion)[0].reshape(-1, 2)
        self.write("points.csv", "\n".join("%f,%f,%f,%f,%f" % (*a, *b) for a, b in zip(pixels, points)))
        camera = yaml.safe_load(camera_yaml())
        camera.update(distortion_model="equidistant", distortion_coefficients={"data": distortion.tolist()})
        self.write("camera.yaml", yaml.safe_dump(camera))
        done = self.call("--points", self.path("points.csv"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_true_pose(1e-4, 0.01)
        for model, count in (("equidistant", 5), ("some_lens", 4)):
            camera.update(distortion_model=model, distortion_coefficients={"data": [0.1] * count})
            self.write("camera.yaml", yaml.safe_dump(camera))
            done = self.call("--points", self.path("points.csv"))
            self.assertEqual(done.returncode, 1)
            self.assertIn("distortion_model", done.stderr)

    def test_a_rotated_rectification_is_only_for_rectified_images(self):
        camera = yaml.safe_load(camera_yaml())
        camera["rectification_matrix"] = {"data": cv2.Rodrigues(np.array([0, 0.02, 0]))[0].ravel().tolist()}
        camera["projection_matrix"] = {"data": np.c_[MATRIX, np.zeros(3)].ravel().tolist()}
        with self.assertRaisesRegex(calibrate_platform.Fault, "--rectified"):
            calibrate_platform.Camera(camera, False)
        calibrate_platform.Camera(camera, True)

    def test_the_stated_intrinsics_are_those_used(self):
        info = yaml.safe_load(camera_yaml())
        info["projection_matrix"]["data"][:2] = [555.5, 0]
        self.assertEqual(calibrate_platform.Camera(info, True).intrinsics, "rectified 640 480 555.5 605.0 310.0 245.0")
        info.update(distortion_model="", distortion_coefficients={"data": [0] * 5})
        camera = calibrate_platform.Camera(info, False)
        camera.see_through(types.SimpleNamespace(x_offset=8, y_offset=8, width=100, height=100), np.array([2, 2]))
        self.assertEqual(camera.intrinsics, "plumb_bob 640 480 600.0 605.0 310.0 245.0", "of the whole sensor")
        info.update(distortion_model="equidistant", distortion_coefficients={"data": [0] * 4})
        self.assertEqual(calibrate_platform.Camera(info, False).intrinsics,
                         "equidistant 640 480 600.0 605.0 310.0 245.0 0.0 0.0 0.0 0.0")

    def test_region_and_binning_are_those_of_the_sensor(self):
        camera = calibrate_platform.Camera(yaml.safe_load(camera_yaml()), False)
        roi = types.SimpleNamespace(x_offset=100, y_offset=40, width=401, height=300)
        camera.see_through(roi, np.array([2, 3]))
        self.assertEqual(camera.size, (200, 100))
        self.assertTrue(np.allclose(camera.matrix, [[300, 0, 104.75], [0, 605 / 3, 68], [0, 0, 1]]), camera.matrix)
        camera = calibrate_platform.Camera(yaml.safe_load(camera_yaml()), False)
        camera.see_through(types.SimpleNamespace(x_offset=0, y_offset=0, width=0, height=0), np.array([1, 1]))
        self.assertEqual(camera.size, (640, 480))
        self.assertTrue(np.array_equal(camera.matrix, MATRIX))

    def test_live_16_bit_images_are_scaled_by_the_white_level(self):
        grey = chessboard()
        deep = np.round(grey * (4095 / 255)).astype(np.uint16)
        for encoding, numbers in (("mono16", deep), ("16UC1", deep), ("mono8", grey)):
            image = calibrate_platform.to_bgr(CvBridge().cv2_to_imgmsg(numbers, encoding), 4095)
            self.assertTrue(np.array_equal(image, cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR)), encoding)
        with self.assertRaises(calibrate_platform.Fault):
            calibrate_platform.to_bgr(CvBridge().cv2_to_imgmsg(deep, "16UC1"), 0)

    def test_topics_without_messages_are_named(self):
        with unittest.mock.patch("rosgraph.is_master_online", return_value=True), \
                unittest.mock.patch("rospy.init_node"), \
                unittest.mock.patch("rospy.resolve_name", side_effect=lambda name: "/cell7/" + name), \
                unittest.mock.patch("rospy.wait_for_message", side_effect=rospy.ROSException("timeout")):
            with self.assertRaisesRegex(calibrate_platform.Fault, "on /cell7/image_raw .* on /cell7/camera_info; .*"
                                        "image_raw:=TOPIC camera_info:=TOPIC"):
                calibrate_platform.live(types.SimpleNamespace(points=None, count=1))

    def test_faults_are_explained(self):
        cv2.imwrite(self.path("empty.png"), np.full((480, 640), 128, np.uint8))
        self.write("few.csv", "1,2,0,0\n3,4,0.1,0\n")
        self.write("bad.csv", "1,2,x,0\n")
        self.write("misfit.csv", "0,0,0,0\n600,0,0.1,0\n0,400,0.1,0.1\n600,400,0,0.3\n300,10,0.2,0.2\n")
        board = ("--chessboard", "7x5", "--square", "0.03", "--image")
        for arguments in ((*board, self.path("empty.png")), (*board, self.path("none.png")),
                          ("--points", self.path("few.csv")), ("--points", self.path("bad.csv")),
                          ("--points", self.path("misfit.csv")), ("--points", self.path("none.csv"))):
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertTrue(done.stderr.startswith("calibrate_platform: "), done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

        self.assertIn("none.csv: No such file", done.stderr)

    def test_a_board_size_without_rows_is_explained(self):
        done = self.call("--chessboard", "9", "--square", "0.03", "--image", self.path("empty.png"))
        self.assertIn("'9' is not the number of inner corners, such as 9x6", done.stderr)

    def test_an_invalid_calibration_is_reported(self):
        self.write("points.csv", "1,2,0,0\n3,4,0.1,0\n5,9,0,0.1\n9,9,0.1,0.1\n")
        for text in ("", "image_width: 640\n", "- 1\n", "{a: [\n", "camera_matrix: {data: [1, 2]}\n"):
            self.write("camera.yaml", text)
            done = self.call("--points", self.path("points.csv"))
            self.assertEqual(done.returncode, 1, text)
            self.assertIn("is not a calibration", done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


unittest.main()
